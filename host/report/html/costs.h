// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/html/report_page.h"
#include "report/render_report.h"

namespace lobe {

struct RunCosts {
    std::string name;  // "rational, compiled for the first time", "rational, from the cache"
    RenderTimes seconds;
};

// Where the time goes: a chart and a table of parse, BVH, compile, upload, render, write.
ReportSection cost_section(const std::vector<RunCosts>& runs);

}  // namespace lobe
