// SPDX-License-Identifier: Apache-2.0
// Memory for what a CPU device reads at random, as a hierarchy of millions of triangles.
#pragma once

#include <cstddef>
#include <memory>

namespace lobe {

// At least `bytes` of host memory, where the system has them in large pages: with small ones most
// random reads miss the processor's cache of addresses too. Nothing if `bytes` is less than some
// large pages, or there is no memory.
std::shared_ptr<void> large_pages(std::size_t bytes);

}  // namespace lobe
