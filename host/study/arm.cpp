// SPDX-License-Identifier: Apache-2.0
#include "study/arm.h"

#include <chrono>
#include <utility>

#include "base/error.h"
#include "base/sha256.h"
#include "base/timer.h"
#include "cl/source.h"
#include "render/render.h"

namespace lobe {
namespace {

template <typename T>
void add_array(Sha256& sum, const std::vector<T>& values) {
    const std::uint64_t count = values.size();
    sum.add(&count, sizeof count);
    sum.add(values.data(), values.size() * sizeof(T));
}

// The integrator is left at its defaults: it does not change the expectation.
std::string hash_content(const PackedScene& packed, const KernelText& kernels) {
    Sha256 sum;
    const std::string header = scene_header(packed.features, packed.models, Integrator());
    sum.add(flatten(kernels, "render.cl", {{"lobe_scene.h", header}}));
    add_array(sum, packed.triangles);
    add_array(sum, packed.vertices);
    add_array(sum, packed.spheres);
    add_array(sum, packed.surfaces);
    add_array(sum, packed.materials);
    add_array(sum, packed.rows);
    add_array(sum, packed.tables);
    add_array(sum, packed.lights.lights);
    add_array(sum, packed.filter_nodes);
    sum.add(&packed.frame, sizeof packed.frame);
    return sum.hex();
}

}  // namespace

Arm::Arm(std::string name, const Device& device, const KernelText& kernels, const Scene& scene,
         const PackOptions& options, double parse_seconds)
    : device_(device), kernels_(kernels), name_(std::move(name)) {
    Stopwatch watch;
    start_up_.parse = parse_seconds;
    packed_ = pack_scene(scene, options);
    start_up_.bvh = watch.restart();
    content_hash_ = hash_content(packed_, kernels);
    session_ = std::make_unique<Session>(device, kernels, packed_);
    start_up_.compile = session_->compile_seconds();
    start_up_.upload = session_->upload_seconds();
    start_up_.compiled_from_cache = session_->compiled_from_cache();
}

ArmRun Arm::run(std::uint64_t seed, std::uint32_t samples, const std::function<bool()>& stop) {
    session_->set_seed(seed);
    RenderPlan plan;
    plan.samples = samples;
    plan.stop = stop;
    const RenderOutcome outcome = render(*session_, plan);
    if (session_->status().trapped())
        throw Error(ExitCode::internal, "the kernel needed what was compiled out", name_,
                    "render with --features all and report this as a fault of lobe");
    return {seed, samples, estimate(outcome.film), outcome.seconds, outcome.stopped};
}

std::unique_ptr<Session> Arm::open_again(Caches caches) const {
    KernelText kernels = kernels_;
    if (caches == Caches::none) {
        const auto now = std::chrono::system_clock::now().time_since_epoch().count();
        kernels.add("render.cl", kernels.read("render.cl") + "\nint unknown_to_caches_" +
                                     std::to_string(now) + "(void) { return 0; }\n");
    }
    return std::make_unique<Session>(device_, kernels, packed_);
}

std::size_t Arm::device_bytes() const { return session_ ? session_->device_bytes() : 0; }

void Arm::close() {
    if (!session_) return;
    session_->keep_program();
    earlier_ = status();
    session_.reset();
}

void Arm::reopen() {
    close();
    session_ = std::make_unique<Session>(device_, kernels_, packed_);
}

RenderStatus Arm::status() const {
    RenderStatus sum = earlier_;
    if (!session_) return sum;
    const RenderStatus last = session_->status();
    for (std::size_t i = 0; i < sum.counters.size(); ++i) sum.counters[i] += last.counters[i];
    return sum;
}

}  // namespace lobe
