// SPDX-License-Identifier: Apache-2.0
// One of the things that an experiment measures: a scene as its options want it, on a device, ready
// to be rendered again and again.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/kernel_text.h"
#include "build/pack.h"
#include "render/session.h"
#include "report/estimate.h"

namespace lobe {

// What is done once, before the first sample; seconds.
struct StartUp {
    double parse = 0, bvh = 0, compile = 0, upload = 0;
    bool compiled_from_cache = false;
    double total() const { return parse + bvh + compile + upload; }
};

// One render of an arm.
struct ArmRun {
    std::uint64_t seed = 0;
    std::uint32_t samples = 0;  // per pixel
    Estimate picture;
    double seconds = 0;    // of rendering, by the clock
    bool stopped = false;  // by the caller: the picture is not whole
};

enum class Caches { none, all };

class Arm {
  public:
    // Packs the scene, compiles its kernel and uploads it. `kernels` holds the user's own models,
    // which have been tried. Throws Error (scene, device).
    Arm(std::string name, const Device& device, const KernelText& kernels, const Scene& scene,
        const PackOptions& options, double parse_seconds = 0);

    const std::string& name() const { return name_; }
    const PackedScene& packed() const { return packed_; }
    const StartUp& start_up() const { return start_up_; }
    std::uint32_t width() const { return packed_.frame.window_width; }
    std::uint32_t height() const { return packed_.frame.window_height; }

    // SHA-256 of all that the picture's expectation depends on: the packed scene, the film, the
    // text of the kernel. Not of the integrator's choices.
    const std::string& content_hash() const { return content_hash_; }

    // Renders so many samples a pixel. Throws Error (internal) if the kernel trapped.
    ArmRun run(std::uint64_t seed, std::uint32_t samples, const std::function<bool()>& stop = {});

    // Compiles its kernel once more, with what caches hold or without: then as a text that has one
    // more function (PoCL's cache looks at what the preprocessor leaves). Throws Error (device).
    std::unique_ptr<Session> open_again(Caches caches) const;
    // The seconds that takes.
    double compile_again(Caches caches) const { return open_again(caches)->compile_seconds(); }

    std::size_t device_bytes() const;  // that it holds now

    // Frees what the device holds; until reopen() nothing may be run.
    void close();
    // Uploads the same scene for the same program anew: where its memory lies, which the speed
    // depends on, is drawn again. start_up() stays as first measured. Throws Error (device).
    void reopen();

    // Sums over all runs so far.
    RenderStatus status() const;
    // Keeps the compiled kernel for later starts.
    void keep_program() const {
        if (session_) session_->keep_program();
    }

  private:
    const Device& device_;
    KernelText kernels_;
    std::string name_;
    PackedScene packed_;
    StartUp start_up_;
    std::string content_hash_;
    std::unique_ptr<Session> session_;  // none while closed
    RenderStatus earlier_;              // of sessions closed
};

}  // namespace lobe
