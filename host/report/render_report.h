// SPDX-License-Identifier: Apache-2.0
// What `lobe render` tells of a render: to a person, and as JSON. Keys carry their unit.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "build/features.h"
#include "cl/device.h"
#include "render/session.h"
#include "base/tail_index.h"
#include "report/estimate.h"

namespace lobe {

// Seconds. The kernel is compiled while hierarchies are built: parts may add up to more than all.
struct RenderTimes {
    double parse = 0, bvh = 0, compile = 0, upload = 0, render = 0, write = 0, total = 0;
};

// What ended a render, and what it was asked to reach.
struct RenderEnd {
    std::string by = "samples";          // samples, error, time or signal
    std::optional<double> error_target;  // relative standard error
    double error_bound = 0;              // what it was below, with 95 % confidence over all looks
    unsigned looks = 0;                  // at the error
    std::optional<double> time_target;   // seconds
    std::uint32_t pilot_samples = 0;     // thrown away, of an adaptive render
    double pilot_seconds = 0;
    double least_rate = 1, most_rate = 1;  // samples of a tile over the mean
};

struct RenderReport {
    std::string scene, scene_hash, dialect, version;
    DeviceInfo device;
    std::uint64_t seed = 0;
    std::uint32_t width = 0, height = 0;
    RenderTimes seconds;
    Estimate picture;
    std::optional<TailIndex> tail;  // of the picture's errors
    RenderEnd end;
    std::vector<std::string> command;
    std::string hash;  // of the picture
    FeatureSet features;
    std::vector<std::string> models;
    Integrator integrator;
    RenderStatistics statistics;
    std::optional<RenderStatus> status;  // unknown where the device no longer answers
    std::size_t triangles = 0, spheres = 0, lights = 0, device_bytes = 0;
    bool partial = false;
    std::vector<std::string> outputs;
};

nlohmann::ordered_json to_json(const RenderReport& report);

// A few lines for standard output: where the picture is, its error, its time, and on the last line
// what the next better picture would cost.
std::string to_text(const RenderReport& report);

}  // namespace lobe
