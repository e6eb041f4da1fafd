// SPDX-License-Identifier: Apache-2.0
#include "report/picture_facts.h"

#include "report/way_on.h"

namespace lobe {

PictureFacts picture_facts(const RenderReport& r, const LobeFrame& frame) {
    PictureFacts facts;
    facts.frame = frame;
    auto& a = facts.attributes;
    a["samplesPerPixel"] = static_cast<int>(r.picture.mean_samples + 0.5);
    a["renderTimeSeconds"] = r.seconds.render;
    a["lobe:seed"] = std::to_string(r.seed);
    if (!r.end.pilot_samples) a["lobe:sampleRange"] = "0:" + std::to_string(r.picture.samples);
    a["lobe:block"] = LOBE_BLOCK;
    a["lobe:integrator"] = to_text(r.integrator);
    a["lobe:replicates"] = LOBE_REPLICATES;
    a["lobe:sceneHash"] = r.scene_hash;
    a["lobe:imageHash"] = r.hash;
    a["lobe:device"] = r.device.name + ", " + r.device.platform + " " + r.device.driver;
    if (r.status) a["lobe:nonfinite"] = static_cast<int>(r.status->nonfinite());
    a["lobe:partial"] = static_cast<int>(r.partial);
    a["lobe:version"] = r.version;
    a["lobe:commandLine"] = command_text(r.command);
    if (r.picture.relative_standard_error)
        a["lobe:relativeStandardError"] = *r.picture.relative_standard_error;
    return facts;
}

}  // namespace lobe
