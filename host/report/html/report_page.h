// SPDX-License-Identifier: Apache-2.0
// A report as plain data, and the one self-contained HTML file made of it: no network, no file
// beside it, readable without scripts and on paper. Texts are plain UTF-8; the writer escapes them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "build/features.h"
#include "cl/device.h"
#include "report/drawing.h"
#include "report/image_file.h"

namespace lobe {

class ImageIo;

// Columns of numbers stand to the right, as in a TextTable. The reader can take the table along as
// CSV.
struct ReportTable {
    std::string title;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  // cells as they are shown
    // What the CSV holds, its head first: all digits, units in the names. Empty: what is shown.
    std::vector<std::vector<std::string>> csv;
    std::string note;  // small print below
};

struct ReportFigure {
    Drawing drawing;  // see report/chart/
    std::string caption;
};

// One picture of a viewer.
struct ReportPicture {
    std::string name;  // on its button: "rational", "reference", "error of phong"
    // Channels R, G, B first (further ones are not shown). Float: linear light, which the slider
    // exposes. Bytes (`bytes`): colours shown as they are, as of a map.
    ImageFile image;
    std::string note;  // shown below while the picture is
};

// Pictures of one size in one frame: buttons choose, a click or a key flips between the last two, a
// slider exposes. Without scripts they stand one below the other. About 9 bytes a pixel and picture
// in the file: give crops of what is large.
struct ReportViewer {
    std::string caption;
    std::vector<ReportPicture> pictures;  // the first is shown, a flip shows the second
    double exposure = 1;                  // where the slider begins: a factor
};

using ReportFacts = std::vector<std::pair<std::string, std::string>>;  // name, value

// Everything is optional, and shown in this order.
struct ReportSection {
    std::string heading;
    std::vector<std::string> paragraphs;
    ReportFacts facts;
    std::vector<ReportFigure> figures;
    std::vector<ReportTable> tables;
    std::vector<ReportViewer> viewers;
};

// What a kernel was compiled with and without.
struct ReportKernel {
    std::string name;  // of the arm, where there are several: "A", "rational"
    FeatureSet features;
    std::vector<std::string> models;
};

// Under which conditions all of it was measured; the page's last section.
struct ReportEnvironment {
    std::string version;  // of lobe
    DeviceInfo device;
    std::string seed;                  // "1" or "1 to 20"
    std::vector<std::string> command;  // as typed
    ReportFacts more;                  // scene hash, start of the run, whatever there is
    std::vector<ReportKernel> kernels;
};

struct ReportPage {
    std::string title;     // "Error against run time: killeroo-simple"
    std::string headline;  // the finding in a sentence or two
    ReportTable table;     // the headline's numbers; no head: none
    std::vector<ReportSection> sections;
    ReportEnvironment environment;
};

// The file's text. Throws Error (output) if a picture cannot be encoded, Error (internal) for a
// viewer whose pictures differ in size or lack R, G, B.
std::string to_html(const ReportPage& page, ImageIo& images);

}  // namespace lobe
