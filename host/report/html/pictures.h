// SPDX-License-Identifier: Apache-2.0
// What a viewer shows of pictures: themselves, and maps of their errors in false colours.
#pragma once

#include "report/html/report_page.h"
#include "report/metrics.h"

namespace lobe {

// Linear light, to be exposed.
ReportPicture linear_picture(const std::string& name, const PictureView& view);

// Relative error of each pixel, as of error_map.h.
ReportPicture error_picture(const std::string& name, const PictureView& view,
                            const PictureView& reference);

// The standard error over the value of each pixel, in the same colours. Needs standard errors.
ReportPicture standard_error_picture(const std::string& name, const PictureView& view);

// (I - R) over its standard error, of each pixel's R, G, B with luminance weights, from blue (-4
// and below) over white to red (4 and above); green is not finite. Needs standard errors of both;
// the channels' are added as if they moved together, as a pixel's mostly do.
ReportPicture z_picture(const std::string& name, const PictureView& view,
                        const PictureView& reference);

// A window of the picture, cut to it: for pages that stay small.
ImageFile cropped(const ImageFile& image, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                  std::uint32_t height);

}  // namespace lobe
