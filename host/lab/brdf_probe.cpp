// SPDX-License-Identifier: Apache-2.0
#include "lab/brdf_probe.h"

#include <algorithm>

#include "base/error.h"
#include "base/kernel_text.h"
#include "cl/kernel_args.h"
#include "cl/source.h"

namespace lobe {
namespace {

// One group size for all calls: PoCL compiles a kernel anew for each.
constexpr std::size_t group = 64;
// A launch's worth of items, below the grids for which PoCL compiles anew.
constexpr std::size_t most_items = 65536 - 2 * group;

constexpr unsigned reciprocal = 1, conserves_energy = 2, keeps_samples = 4;

Program build(const Device& device, const KernelText& kernels, const BrdfTable& model,
              Precision precision) {
    ProgramOptions options;
    options.double_precision = precision == Precision::twice;
    return build_program(device, brdf_probe_source(kernels, model), options);
}

std::size_t padded(std::size_t count) { return (count + group - 1) / group * group; }

template <typename Real>
std::vector<Real> numbers(const std::vector<glm::dvec3>& vectors, std::size_t first,
                          std::size_t count) {
    std::vector<Real> out(3 * padded(count), Real(0.5));  // the padding is a harmless direction
    for (std::size_t i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) out[3 * i + k] = static_cast<Real>(vectors[first + i][k]);
    return out;
}

}  // namespace

std::string brdf_probe_source(const KernelText& kernels, const BrdfTable& model) {
    const std::string header = "#include \"" + model.file + "\"\n#define LOBE_PROBE_BRDF " +
                               model.name + "\n#define LOBE_PROBE_FORMULA " +
                               (model.has_formula ? "1\n" : "0\n");
    return flatten(kernels, "probe/brdf.cl", {{"probe_brdf.h", header}});
}

BrdfProbe::BrdfProbe(const Device& device, const KernelText& kernels, const BrdfTable& model,
                     Precision precision)
    : device_(device),
      model_(model),
      precision_(precision),
      program_(build(device, kernels, model, precision)),
      rows_(device, std::vector<LobeRow>{}),
      prepared_(device, std::vector<cl_uchar>{}),
      tables_(device, std::vector<cl_float>{}) {
    set_parameters({model.default_rows()});
}

void BrdfProbe::set_parameters(const std::vector<BrdfRows>& sets,
                               const std::vector<float>& tables) {
    std::vector<LobeRow> rows;
    const std::size_t count = padded(sets.size());
    for (std::size_t i = 0; i < count; ++i)
        for (const auto& row : sets[std::min(i, sets.size() - 1)])
            rows.push_back({row[0], row[1], row[2], row[3]});
    rows_ = Buffer<LobeRow>(device_, rows);
    tables_ = Buffer<cl_float>(device_, tables);
    prepared_ = Buffer<cl_uchar>(device_, count * LOBE_PREPARED_BYTES);
    Buffer<cl_uint> out(device_, 2 * count);
    cl::Kernel kernel = program_.kernel("brdf_prepare");
    set_args(kernel, rows_, static_cast<cl_uint>(model_.parameters.size()), prepared_, out);
    launch(device_, kernel, cl::NDRange(count), cl::NDRange(group));
    const std::vector<cl_uint> facts = out.read_all();
    claims_.clear();
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const cl_uint bits = facts[2 * i];
        claims_.push_back({(bits & reciprocal) != 0, (bits & conserves_energy) != 0,
                           (bits & keeps_samples) != 0});
    }
    prepared_bytes_ = facts[1];
}

template <typename Real>
std::vector<double> BrdfProbe::run(const char* name, const BrdfQuery& query,
                                   std::size_t width) const {
    std::vector<double> all;
    all.reserve(width * query.size());
    cl::Kernel kernel = program_.kernel(name);
    const bool formula = width == 3;
    for (std::size_t first = 0; first < query.size(); first += most_items) {
        const std::size_t count = std::min(query.size() - first, most_items);
        const std::size_t items = padded(count);
        std::vector<cl_uint> sets(items, 0);
        std::copy_n(query.sets.begin() + static_cast<std::ptrdiff_t>(first), count, sets.begin());
        const Buffer<cl_uint> set_of(device_, sets);
        const Buffer<Real> wo(device_, numbers<Real>(query.wo, first, count));
        const Buffer<Real> second(device_, numbers<Real>(query.second, first, count));
        const Buffer<Real> out(device_, width * items);
        if (formula)
            set_args(kernel, rows_, static_cast<cl_uint>(model_.parameters.size()), set_of, wo,
                     second, out);
        else
            set_args(kernel, prepared_, tables_, set_of, wo, second, out);
        launch(device_, kernel, cl::NDRange(items), cl::NDRange(group));
        std::vector<Real> part(width * count);
        out.read(part.data(), part.size());
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

std::vector<double> BrdfProbe::run(const char* name, const BrdfQuery& query,
                                   std::size_t width) const {
    if (query.wo.size() != query.size() || query.second.size() != query.size())
        throw Error(ExitCode::internal, "a query's arrays differ in length");
    return precision_ == Precision::twice ? run<double>(name, query, width)
                                          : run<float>(name, query, width);
}

std::vector<BrdfValue> BrdfProbe::eval(const BrdfQuery& query) const {
    const std::vector<double> out = run("brdf_eval", query, 4);
    std::vector<BrdfValue> values(query.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = {{out[4 * i], out[4 * i + 1], out[4 * i + 2]}, out[4 * i + 3]};
    return values;
}

std::vector<BrdfSampled> BrdfProbe::sample(const BrdfQuery& query) const {
    const std::vector<double> out = run("brdf_sample", query, 8);
    std::vector<BrdfSampled> samples(query.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double* o = &out[8 * i];
        samples[i] = {{o[0], o[1], o[2]}, o[3], {o[4], o[5], o[6]}, o[7] != 0};
    }
    return samples;
}

std::vector<glm::dvec3> BrdfProbe::formula(const BrdfQuery& query) const {
    const std::vector<double> out = run("brdf_formula", query, 3);
    std::vector<glm::dvec3> values(query.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = {out[3 * i], out[3 * i + 1], out[3 * i + 2]};
    return values;
}

BrdfRows brdf_rows(const BrdfTable& model,
                   const std::vector<std::pair<std::string, double>>& values) {
    BrdfRows rows = model.default_rows();
    for (const auto& [name, value] : values) {
        const int place = model.find(name);
        if (place < 0)
            throw Error(ExitCode::usage, model.name + " has no parameter '" + name + "'", "",
                        "lobe brdf list shows the parameters of each model");
        const auto row = static_cast<std::size_t>(place);
        rows[row] = {static_cast<float>(value), 0, 0, 0};
        if (model.parameters[row].kind == BrdfParameterKind::color)
            rows[row][1] = rows[row][2] = rows[row][0];
    }
    return rows;
}

}  // namespace lobe
