// SPDX-License-Identifier: Apache-2.0
// A model is one file: one that lobe has never seen is listed, rendered, checked, tabulated,
// plotted and documented with no edit elsewhere, given with the command or laid into kernels/brdf/.
#include <filesystem>

#include "base/files.h"
#include "cli.h"

using namespace lobe;
using namespace lobe::test;

namespace {

namespace fs = std::filesystem;

const char* const retro_text = R"(// SPDX-License-Identifier: Apache-2.0
// Retro: f = kd + ks c^n, c the cosine between wo and wi: a lobe back to where the light came from.
// Source: this test.
//
// Reciprocal; conserves energy for pi kd + 2 pi ks / (n + 1) <= 1. Sampling: cosine.
#ifndef RETRO_H
#define RETRO_H

#include "brdf/brdf.h"
#include "core/warp.h"

#define retro_parameters(P) \
    P(color, kd, 0.15, 0, inf, "diffuse part, 1/sr") \
    P(color, ks, 0.1, 0, inf, "lobe towards the light, 1/sr") \
    P(number, n, 6, 0, 20, "exponent")
LOBE_BRDF_VALUES(retro)

typedef struct {
    real3 kd, ks;
    real n;
} retro_prepared;

retro_prepared retro_prepare(retro_values values) {
    retro_prepared m = {values.kd, values.ks, values.n};
    return m;
}

int retro_claims(retro_values values) {
    return LOBE_BRDF_RECIPROCAL | LOBE_BRDF_KEEPS_SAMPLES |
           LOBE_BRDF_CONSERVES_BELOW(REAL_PI * values.kd +
                                     REAL_TWO_PI / (values.n + 1) * values.ks);
}

real3 retro_formula(retro_values values, real3 wo, real3 wi) {
    real c = dot(wo, wi);
    return c > 0 ? values.kd + values.ks * pow(c, values.n) : values.kd;
}

real3 retro_eval(const retro_prepared* m, real3 wo, real3 wi) {
    real3 d = wo - wi;
    real x = R(0.5) * dot(d, d), c = x < R(0.5) ? 1 - x : dot(wo, wi);
    if (!(c > 0)) return m->kd * wi.z;
    return (m->kd + m->ks * real_exp(m->n * real_log_split(c, x))) * wi.z;
}

real retro_pdf(const retro_prepared* m, real3 wo, real3 wi) { return wi.z * REAL_INV_PI; }

BrdfSample retro_sample(const retro_prepared* m, real3 wo, real3 u) {
    BrdfSample sample = brdf_no_sample();
    sample.wi = cosine_hemisphere(u.xy);
    sample.pdf = retro_pdf(m, wo, sample.wi);
    sample.weight = retro_eval(m, wo, sample.wi) / sample.pdf;
    return sample;
}

#endif
)";

class OwnModel : public Cli {
  protected:
    RunResult good(const std::vector<std::string>& arguments) const {
        RunOptions options;
        options.timeout = 100;
        const RunResult result = lobe(arguments, options);
        EXPECT_EQ(result.code, 0) << arguments[1] << ": " << result.err << result.out;
        return result;
    }

    // All that one can do with a model called `word`, with `more` arguments.
    void use(const std::string& word, const std::vector<std::string>& more,
             const std::vector<std::string>& render_more) const {
        const auto with = [](std::vector<std::string> a, const std::vector<std::string>& b) {
            a.insert(a.end(), b.begin(), b.end());
            return a;
        };
        const auto json =
            render(with({"--replace", "rational=retro", "--n", "8", "--strict"}, render_more));
        EXPECT_GT(json["error"]["mean"], 0);
        good(with({"brdf", "check", word, "--quiet"}, more));
        const RunResult table = good(with({"brdf", "table", word, "--quiet"}, more));
        EXPECT_NE(table.out.find("retro"), std::string::npos);
        good(with({"brdf", "plot", word, "-o", "retro.svg", "--quiet"}, more));
        EXPECT_NE(read_file(path("retro.svg")).find("<svg"), std::string::npos);
        good(with({"brdf", "doc", word, "-o", "pages", "--quiet"}, more));
        const std::string page = read_file(path("pages/retro.md"));
        for (const char* part : {"a lobe back to where the light", "this test",
                                 "lobe towards the light, 1/sr", "conserves energy"})
            EXPECT_NE(page.find(part), std::string::npos) << part;
    }
};

}  // namespace

TEST_F(OwnModel, AsAFileOfOnesOwn) {
    folder_.write("retro.cl", retro_text);
    use("retro.cl", {}, {"--brdf", "retro.cl"});
}

TEST_F(OwnModel, AsAFileAmongTheKernels) {
    fs::copy(std::string(LOBE_SOURCE_DIR) + "/kernels", path("kernels"),
             fs::copy_options::recursive);
    folder_.write("kernels/brdf/retro.h", retro_text);
    const std::vector<std::string> kernels = {"--kernel-dir", "kernels"};
    EXPECT_NE(good({"brdf", "list", "--kernel-dir", "kernels"}).out.find("retro "),
              std::string::npos);
    use("retro", kernels, kernels);
}
