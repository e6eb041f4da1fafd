// SPDX-License-Identifier: Apache-2.0
#include "render/render_kernel.h"

#include "base/kernel_text.h"
#include "base/timer.h"
#include "cl/buffer.h"
#include "cl/kernel_args.h"
#include "cl/source.h"
#include "render/lanes.h"

namespace lobe {
namespace {

// Devices and kernels may allow fewer work-items in a group; the bits do not depend on it.
std::array<unsigned, 2> fitting(std::array<unsigned, 2> local, const cl::Kernel& kernel,
                                const Device& device) {
    const auto most = checked(
        [&] { return kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device.device()); });
    auto& [x, y] = local;
    while (std::size_t{x} * y > most && x * y > 1) (x > y ? x : y) /= 2;
    return local;
}

// A frame without tiles ends every work-item before it looks at anything else, and so does a count
// of no materials.
void launch_empty(const Device& device, cl::Kernel& render, cl::Kernel prepare,
                  const std::array<unsigned, 2>& local) {
    const Buffer<LobeFrame> none(device, std::vector<LobeFrame>(1));
    const auto [x, y] = local;
    const auto count = checked([&] { return render.getInfo<CL_KERNEL_NUM_ARGS>(); });
    for (cl_uint i = 0; i < count; ++i) checked([&] { render.setArg(i, none.get()); });
    launch(device, render, cl::NDRange(x, y), cl::NDRange(x, y));
    set_args(prepare, none, none, none, cl_uint{0}, none);
    launch(device, prepare, cl::NDRange(1), cl::NDRange(1));
    device.finish();
}

}  // namespace

RenderKernel::RenderKernel(const Device& device, const KernelText& kernels,
                           const KernelNeeds& needs, const KernelOptions& options) {
    const Stopwatch watch;
    const std::string header =
        scene_header(needs.features, needs.models, needs.integrator,
                     options.abreast ? options.abreast : suitable_lanes(device.info()));
    program = build_program(device, flatten(kernels, "render.cl", {{"lobe_scene.h", header}}),
                            {options.double_precision});
    render = program.kernel("render");
    local = fitting(options.local, render, device);
    launch_empty(device, render, program.kernel("prepare"), local);
    seconds = watch.seconds();
}

}  // namespace lobe
