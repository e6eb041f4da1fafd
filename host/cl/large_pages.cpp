// SPDX-License-Identifier: Apache-2.0
#include "cl/large_pages.h"

#include <sys/mman.h>

#include <cstdlib>

namespace lobe {

std::shared_ptr<void> large_pages(std::size_t bytes) {
    constexpr std::size_t page = 2u << 20;
    if (bytes < 2 * page) return nullptr;
    const std::size_t whole = (bytes + page - 1) / page * page;
    std::shared_ptr<void> memory(std::aligned_alloc(page, whole), std::free);
#ifdef MADV_HUGEPAGE
    if (memory) madvise(memory.get(), whole, MADV_HUGEPAGE);  // a wish: the memory is good without
#endif
    return memory;
}

}  // namespace lobe
