// SPDX-License-Identifier: Apache-2.0
#include "cl/memory.h"

#include <algorithm>

#include "base/error.h"
#include "base/progress.h"

namespace lobe {

std::uint64_t MemoryAccount::reserve(std::uint64_t count, std::uint64_t size,
                                     const std::string& what) {
    const std::string needs = what + " needs " +
                              bytes_text(static_cast<double>(count) * static_cast<double>(size)) +
                              " of the device's memory, ";
    const std::string hint = "try a smaller film or scene, or another --device";
    if (size && count > largest_ / size)
        throw Error(ExitCode::device,
                    needs + "but one buffer may have " + bytes_text(static_cast<double>(largest_)) +
                        " at most",
                    "", hint);
    const std::uint64_t bytes = count * size;
    if (bytes > total_ - used_)
        throw Error(ExitCode::device,
                    needs + "but " + bytes_text(static_cast<double>(total_ - used_)) + " of " +
                        bytes_text(static_cast<double>(total_)) + " are free",
                    "", hint);
    used_ += bytes;
    peak_ = std::max(peak_, used_);
    return bytes;
}

}  // namespace lobe
