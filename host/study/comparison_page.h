// SPDX-License-Identifier: Apache-2.0
// `lobe compare` as a page to look at.
#pragma once

#include "report/html/report_page.h"
#include "study/comparison_report.h"

namespace lobe {

// The verdicts with their intervals, what is behind them, and every run as CSV. The report is
// judged; `command` is the command line word by word.
ReportPage comparison_page(const ComparisonReport& report);

}  // namespace lobe
