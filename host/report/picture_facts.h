// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/picture.h"
#include "report/render_report.h"

namespace lobe {

// What the header of a render's EXR says: samples, seed, error, device, command line.
PictureFacts picture_facts(const RenderReport& report, const LobeFrame& frame);

}  // namespace lobe
