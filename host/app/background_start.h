// SPDX-License-Identifier: Apache-2.0
// The device and the kernel of a render, made ready while its scene is read and its hierarchies are
// built.
#pragma once

#include <future>
#include <optional>
#include <string>

#include "cl/device.h"
#include "render/render_kernel.h"

namespace lobe {

class BackgroundStart {
  public:
    // Begins to open the device that `choice` means, as open_device().
    explicit BackgroundStart(const std::string& choice);

    // Begins to compile, once the device is open. `kernels` must stay as it is until kernel() or
    // the end.
    void compile(const KernelText& kernels, const KernelNeeds& needs);

    // Waits for it. Throws what opening it threw.
    const Device& device() const { return device_.get(); }

    // Waits for the kernel; nothing if compile() was not called, or once more. Throws what
    // compiling it threw.
    std::optional<RenderKernel> kernel();

  private:
    std::shared_future<Device> device_;
    std::future<RenderKernel> kernel_;
};

}  // namespace lobe
