// SPDX-License-Identifier: Apache-2.0
// A series of numbers as one line of text: "▁▂▄▇█".
#pragma once

#include <string>
#include <vector>

namespace lobe {

enum class SparkScale { linear, logarithmic };
enum class SparkSet { automatic, blocks, ascii };

// A character a value: the lowest bar for the least, the highest for the largest, a bar of middle
// height for all if they are equal. A space stands for what has no place on the scale: values that
// are not finite and, on a logarithmic one, not positive. `automatic` takes blocks where the
// locale's characters are UTF-8, else ASCII: "_.-=*#".
std::string sparkline(const std::vector<double>& values, SparkScale scale = SparkScale::linear,
                      SparkSet set = SparkSet::automatic);

// Whether the environment (LC_ALL, else LC_CTYPE, else LANG) asks for UTF-8.
bool locale_is_utf8();

}  // namespace lobe
