// SPDX-License-Identifier: Apache-2.0
// Pictures of the difference of two pictures.
#pragma once

#include "report/image_file.h"
#include "report/metrics.h"

namespace lobe {

// Float32 |I - R| as R, G, B; where both carry standard errors also Z.R, .G, .B = (I - R) over the
// standard error of that, 0 where both are 0. With K replicates Z is no normal deviate: its few
// degrees of freedom make values of ten and more common. The caller sets the window.
ImageFile absolute_error_picture(const PictureView& picture, const PictureView& reference);

// Relative error in false colours, 8 bits: |I - R| over |R| as vectors in RGB (a hundredth of R's
// mean square is added to its square), on a logarithmic scale from 0.1 % (black) over blue, red,
// yellow to 100 % (white). What is not finite is green.
ImageFile false_colour_error(const PictureView& picture, const PictureView& reference);

}  // namespace lobe
