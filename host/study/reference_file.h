// SPDX-License-Identifier: Apache-2.0
// A reference as a picture file: R, G, B and StdError.R, .G, .B, .Y (of the luminance), Mask.
#pragma once

#include "report/image_file.h"
#include "study/reference.h"

namespace lobe {

// The picture, with the content hash of what it shows and a checksum of its values.
ImageFile reference_picture(const Reference& reference, const std::string& content_hash);

// What a file of reference_picture() holds. Throws Error (scene) with the reason if it is damaged,
// of another content or no reference at all.
Reference checked_reference(const ImageFile& picture, const std::string& content_hash);

// What any picture holds; errors and mask are left out where it has none. Throws Error (scene) if
// it has no R, G, B or not this size.
Reference any_reference(const ImageFile& picture, std::uint32_t width, std::uint32_t height);

}  // namespace lobe
