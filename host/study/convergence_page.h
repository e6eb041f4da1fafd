// SPDX-License-Identifier: Apache-2.0
// `lobe converge` as a page to look at.
#pragma once

#include "report/html/report_page.h"
#include "study/convergence_report.h"

namespace lobe {

// The figures of to_text(), charts of the error against samples and time, every render as CSV, and
// the references. At least one scene; `command` is the command line word by word.
ReportPage convergence_page(const ConvergenceResults& results);

}  // namespace lobe
