// SPDX-License-Identifier: Apache-2.0
#include "lab/trial/trial_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "cl/kernel_args.h"
#include "cl/program.h"
#include "lab/brdf_probe.h"
#include "lab/trial/guarded_buffer.h"
#include "lab/trial/model_fault.h"
#include "lab/parameter_sweep.h"
#include "lab/settings.h"

namespace lobe {
namespace {

constexpr std::size_t group = 64;         // as in BrdfProbe, so that PoCL's cache serves both
constexpr std::size_t chunk = 4096;       // items of a launch: a step is short, on simulators too
constexpr std::size_t pairs_a_set = 128;  // for each set of parameters but the first
constexpr std::size_t most_sets = 96;

const float inf = std::numeric_limits<float>::infinity();
const float nan = std::numeric_limits<float>::quiet_NaN();

using Vector = std::array<float, 3>;

// Directions that models get, and some that they never should.
std::vector<Vector> trial_directions() {
    std::vector<Vector> all = {
        {0, 0, 1},      {0.6f, 0, 0.8f}, {-0.6f, 0, 0.8f},    {0.8f, -0.6f, 0},  {1, 0, 1e-3f},
        {-1, 0, 1e-7f}, {0, 1, 1e-30f},  {1, 0, 1.18e-38f},   {0, -1, 1e-45f},   {0.6f, 0, -0.8f},
        {0, 0, -1},     {0, 0, 0},       {1e-30f, 0, 1e-30f}, {1e30f, 0, 1e30f}, {inf, 0, 1},
        {0, 0, inf},    {nan, nan, nan}, {0, 0, nan}};
    Random random(1);
    for (int i = 0; i < 12; ++i) {
        const double z = random.uniform(), r = std::sqrt(1 - z * z);
        const double azimuth = 6.283185307179586 * random.uniform();
        all.push_back({static_cast<float>(r * std::cos(azimuth)),
                       static_cast<float>(r * std::sin(azimuth)), static_cast<float>(z)});
    }
    return all;
}

// Numbers u of samples: corners of the cube, whose upper ends are the largest below one, and
// others.
std::vector<Vector> trial_numbers() {
    const float last = 1 - 0x1p-24f;
    std::vector<Vector> all;
    for (const float x : {0.0f, 0.5f, last})
        for (const float y : {0.0f, 0.25f, 0.5f, last})
            for (const float z : {0.0f, 0.5f, last}) all.push_back({x, y, z});
    Random random(2);
    for (int i = 0; i < 12; ++i)
        all.push_back({random.uniform_float(), random.uniform_float(), random.uniform_float()});
    return all;
}

// Items of calls: which parameter set, towards which viewer, and wi or u.
struct Items {
    std::vector<cl_uint> sets;
    std::vector<Vector> wo, second;

    // All pairs with the first set, some with every other one.
    Items(std::size_t set_count, const std::vector<Vector>& views,
          const std::vector<Vector>& others, std::uint64_t seed) {
        for (const Vector& view : views)
            for (const Vector& other : others) add(0, view, other);
        Random random(seed);
        const auto any = [&](const std::vector<Vector>& of) {
            return of[random.below(static_cast<std::uint32_t>(of.size()))];
        };
        for (cl_uint set = 1; set < set_count; ++set)
            for (std::size_t i = 0; i < pairs_a_set; ++i) add(set, any(views), any(others));
        while (sets.size() % group) add(0, views[0], others[0]);
    }
    void add(cl_uint set, const Vector& view, const Vector& other) {
        sets.push_back(set);
        wo.push_back(view);
        second.push_back(other);
    }
};

class Trial {
  public:
    Trial(const Device& device, const KernelText& kernels, const BrdfTable& model,
          const std::function<void(const std::string&)>& step)
        : device_(device), model_(model), step_(step) {
        step("the build");
        try {
            program_ = build_program(device, brdf_probe_source(kernels, model));
        } catch (const Error& error) {
            throw build_fault(error, kernels, model);
        }
    }

    void run() {
        prepare();
        const std::vector<Vector> directions = trial_directions();
        const Items pairs(sets_, directions, directions, 3);
        call("_eval", "brdf_eval", pairs, 4);
        call("_sample", "brdf_sample", Items(sets_, directions, trial_numbers(), 4), 8);
        if (model_.has_formula) call("_formula", "brdf_formula", pairs, 3);
    }

  private:
    // Launches a kernel, and looks at the fences of all it was given.
    template <typename... Args>
    void launch_guarded(const std::string& function, const char* kernel_name, std::size_t items,
                        const Args&... args) {
        step_(model_.name + function);
        cl::Kernel kernel = program_.kernel(kernel_name);
        set_args(kernel, argument(args)...);
        launch(device_, kernel, cl::NDRange(items), cl::NDRange(group));
        device_.finish();
        if (!(intact(args) && ...))
            throw Error(ExitCode::device, model_.name + function + " wrote beyond a buffer",
                        model_.file, "look at its pointers and array indices");
    }
    static const cl::Buffer& argument(const GuardedBuffer& buffer) { return buffer.get(); }
    static cl_uint argument(cl_uint number) { return number; }
    static bool intact(const GuardedBuffer& buffer) { return buffer.intact(); }
    static bool intact(cl_uint) { return true; }

    cl_uint rows_per_set() const { return static_cast<cl_uint>(model_.parameters.size()); }

    void prepare() {
        std::vector<ParameterSet> sets = parameter_sweep(model_, most_sets / 3);
        const std::vector<ParameterSet> extremes = extreme_parameters(model_);
        const std::size_t step = 1 + extremes.size() / (most_sets - sets.size());
        for (std::size_t i = 0; i < extremes.size(); i += step) sets.push_back(extremes[i]);
        sets_ = sets.size();
        while (sets.size() % group) sets.push_back(sets[0]);
        std::vector<float> rows;
        for (const ParameterSet& set : sets)
            for (const auto& row : set.rows) rows.insert(rows.end(), row.begin(), row.end());
        rows_ = std::make_unique<GuardedBuffer>(device_, rows.size() * sizeof(float), rows.data());
        // A prepared form that is too large must still find room, to be told so.
        prepared_ = std::make_unique<GuardedBuffer>(
            device_, sets.size() * LOBE_PREPARED_BYTES + (std::size_t{1} << 20));
        const std::vector<float> tables = set_up(model_, {}).tables;
        tables_ =
            std::make_unique<GuardedBuffer>(device_, tables.size() * sizeof(float), tables.data());
        const GuardedBuffer facts(device_, 2 * sets.size() * sizeof(cl_uint));
        launch_guarded("_prepare", "brdf_prepare", sets.size(), *rows_, rows_per_set(), *prepared_,
                       facts);
        cl_uint bytes = 0;
        checked([&] {
            device_.queue().enqueueReadBuffer(facts.get(), CL_TRUE, sizeof bytes, sizeof bytes,
                                              &bytes);
        });
        if (bytes > LOBE_PREPARED_BYTES)
            throw Error(ExitCode::scene,
                        model_.name + "_prepared has " + std::to_string(bytes) +
                            " bytes, more than the " + std::to_string(LOBE_PREPARED_BYTES) +
                            " there are",
                        model_.file, "compute more in eval and sample");
    }

    void call(const std::string& function, const char* kernel, const Items& items,
              std::size_t numbers) {
        for (std::size_t first = 0; first < items.sets.size(); first += chunk) {
            const std::size_t count = std::min(chunk, items.sets.size() - first);
            const auto part = [&](const auto& of) {
                return std::make_unique<GuardedBuffer>(device_, count * sizeof of[0], &of[first]);
            };
            const auto sets = part(items.sets), wo = part(items.wo), second = part(items.second);
            const GuardedBuffer out(device_, count * numbers * sizeof(float));
            if (function == "_formula")
                launch_guarded(function, kernel, count, *rows_, rows_per_set(), *sets, *wo, *second,
                               out);
            else
                launch_guarded(function, kernel, count, *prepared_, *tables_, *sets, *wo, *second,
                               out);
        }
    }

    const Device& device_;
    const BrdfTable& model_;
    const std::function<void(const std::string&)>& step_;
    Program program_;
    std::size_t sets_ = 0;
    std::unique_ptr<GuardedBuffer> rows_, prepared_, tables_;
};

}  // namespace

void run_trial(const Device& device, const KernelText& kernels, const BrdfTable& model,
               const std::function<void(const std::string&)>& step) {
    Trial(device, kernels, model, step).run();
}

}  // namespace lobe
