// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/html/report_page.h"
#include "report/render_report.h"

namespace lobe {

// The report of one render: the picture with its error map, where the time went, what was compiled.
// The middle 700x700 pixels of a larger picture are shown.
ReportPage render_report_page(const RenderReport& report, double exposure = 1);

// As a file's text.
std::string render_page(const RenderReport& report, ImageIo& images, double exposure = 1);

}  // namespace lobe
