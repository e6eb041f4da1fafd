// SPDX-License-Identifier: Apache-2.0
// `lobe bench` as a page to look at.
#pragma once

#include "report/html/report_page.h"
#include "study/bench/bench.h"

namespace lobe {

// Rates, times and memory of every scene, and plots of what grows.
ReportPage bench_page(const BenchReport& report);

}  // namespace lobe
