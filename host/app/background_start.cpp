// SPDX-License-Identifier: Apache-2.0
#include "app/background_start.h"

namespace lobe {

BackgroundStart::BackgroundStart(const std::string& choice)
    : device_(std::async(std::launch::async, [choice] { return open_device(choice); })) {}

void BackgroundStart::compile(const KernelText& kernels, const KernelNeeds& needs) {
    kernel_ = std::async(std::launch::async, [device = device_, &kernels, needs] {
        return RenderKernel(device.get(), kernels, needs);
    });
}

std::optional<RenderKernel> BackgroundStart::kernel() {
    if (!kernel_.valid()) return {};
    return kernel_.get();
}

}  // namespace lobe
