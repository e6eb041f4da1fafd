// SPDX-License-Identifier: Apache-2.0
// The parts of which report_page.cpp makes a page, each as HTML.
#pragma once

#include <string>

#include "report/html/report_page.h"

namespace lobe {

// <name>text</name>, the text escaped.
std::string element(const std::string& name, const std::string& text);

// With a link that holds it as CSV (RFC 4180); "" without a head.
std::string table_html(const ReportTable& table);

// The table as CSV.
std::string csv_of(const ReportTable& table);

// All pictures one below the other, which the page's script makes a viewer of.
std::string viewer_html(const ReportViewer& viewer, ImageIo& images);

// The page's last section.
std::string environment_html(const ReportEnvironment& environment);

std::string facts_html(const ReportFacts& facts);

// The page's one style sheet and one script.
extern const char* const page_style;
extern const char* const page_script;

}  // namespace lobe
