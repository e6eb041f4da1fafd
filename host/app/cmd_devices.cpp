// SPDX-License-Identifier: Apache-2.0
// lobe devices: what there is to render on.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "base/log.h"
#include "base/progress.h"
#include "cl/device.h"

namespace lobe {
namespace {

nlohmann::ordered_json to_json(const DeviceInfo& d, bool chosen) {
    return {{"number", d.number},
            {"name", d.name},
            {"type", device_type_name(d.type)},
            {"platform", d.platform},
            {"driver", d.driver},
            {"version", d.version},
            {"compute_units", d.compute_units},
            {"clock_mhz", d.clock_mhz},
            {"global_memory_bytes", d.global_memory},
            {"largest_allocation_bytes", d.largest_allocation},
            {"fp64", d.fp64},
            {"correctly_rounded_divide_sqrt", d.correctly_rounded},
            {"default", chosen}};
}

int run(const CommonOptions& options) {
    set_quiet(options.quiet);
    const std::vector<DeviceInfo> devices = list_devices();
    const std::size_t chosen = chosen_device(devices, options.device);
    auto json = nlohmann::ordered_json::array();
    for (const DeviceInfo& d : devices) {
        json.push_back(to_json(d, d.number == devices[chosen].number));
        if (options.json == "-") continue;
        std::printf(
            "%c %u  %s  %s\n     %s, driver %s\n     %u compute units, %s, largest buffer %s%s\n",
            d.number == devices[chosen].number ? '*' : ' ', d.number, device_type_name(d.type),
            d.name.c_str(), d.platform.c_str(), d.driver.c_str(), d.compute_units,
            bytes_text(static_cast<double>(d.global_memory)).c_str(),
            bytes_text(static_cast<double>(d.largest_allocation)).c_str(), d.fp64 ? ", fp64" : "");
    }
    if (!options.json.empty()) write_json(options.json, json.dump(2) + "\n");
    return 0;
}

}  // namespace

Command add_devices_command(CLI::App& app) {
    CLI::App* verb =
        app.add_subcommand("devices", "list the OpenCL devices; * is the one a render takes");
    auto options = std::make_shared<CommonOptions>();
    add_common_options(*verb, *options);
    return [options] { return run(*options); };
}

}  // namespace lobe
