// SPDX-License-Identifier: Apache-2.0
// The paper's experiment as a page to look at.
#pragma once

#include "report/html/report_page.h"
#include "study/paper/report.h"

namespace lobe {

// Tables, claims and, where the experiment kept pictures, crops of references, single runs and
// their errors: where the models' pictures differ most.
ReportPage page_of(const PaperReport& report);

// A part of a film.
struct Crop {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

// The part, at most `side` pixels wide and high, in which two pictures differ most (mean absolute
// difference, 3 channels), among those that lie 16 pixels apart.
Crop busiest_crop(const std::vector<float>& a, const std::vector<float>& b, std::uint32_t width,
                  std::uint32_t height, std::uint32_t side);

}  // namespace lobe
