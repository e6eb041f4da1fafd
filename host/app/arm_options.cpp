// SPDX-License-Identifier: Apache-2.0
#include "app/arm_options.h"

#include <algorithm>

#include "app/usage.h"
#include "app/user_models.h"
#include "base/timer.h"

namespace lobe {
namespace {

std::string replaced_type(const std::string& pair) { return pair.substr(0, pair.find('=')); }

// Those of `base` that `own` does not speak of, and then its own.
std::vector<std::string> join_replacements(const std::vector<std::string>& base,
                                           const std::vector<std::string>& own) {
    std::vector<std::string> all;
    for (const std::string& pair : base) {
        const bool given = std::any_of(own.begin(), own.end(), [&](const std::string& other) {
            return replaced_type(other) == replaced_type(pair);
        });
        if (!given) all.push_back(pair);
    }
    all.insert(all.end(), own.begin(), own.end());
    return all;
}

void parse_into(SceneOptions& options, std::vector<std::string> words) {
    CLI::App app("", "lobe");
    CLI::App* verb = app.add_subcommand("compare");
    verb->set_help_flag();
    add_scene_options(*verb, options);
    verb->remove_option(verb->get_option("scene"));
    words.insert(words.begin(), "compare");
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    try {
        app.parse(std::move(words));
    } catch (const CLI::ParseError& fault) {
        throw usage_error(app, fault);
    }
}

}  // namespace

Error in_option(const std::string& name, const Error& error) {
    return Error(error.code(), "in " + name + ": " + error.what(), error.where(), error.hint());
}

std::vector<std::string> split_words(const std::string& text) {
    std::vector<std::string> words;
    bool inside = false;  // of a word
    char quote = 0;
    for (char c : text) {
        if (quote ? c == quote : (c == '"' || c == '\'')) {
            quote = quote ? 0 : c;
            if (!inside) words.emplace_back();
            inside = true;
        } else if (!quote && (c == ' ' || c == '\t' || c == '\n')) {
            inside = false;
        } else {
            if (!inside) words.emplace_back();
            inside = true;
            words.back() += c;
        }
    }
    if (quote)
        throw Error(ExitCode::usage, std::string("a quote ") + quote + " has no end: " + text, "",
                    "close it, or write '...' inside \"...\"");
    return words;
}

SceneOptions arm_options(const SceneOptions& base, const std::string& name,
                         const std::string& text) {
    SceneOptions options = base;
    options.brdfs.clear();
    options.replace.clear();
    try {
        parse_into(options, split_words(text));
    } catch (const Error& error) {
        throw in_option(name, error);
    }
    if (options.spp != base.spp)
        throw Error(ExitCode::usage, "in " + name + ": --spp is the experiment's choice", "",
                    "give --spp to lobe compare itself, for both");
    options.brdfs.insert(options.brdfs.begin(), base.brdfs.begin(), base.brdfs.end());
    options.replace = join_replacements(base.replace, options.replace);
    return options;
}

std::optional<ArmParts> read_arm(const Device& device, KernelText& kernels,
                                 const SceneOptions& options, const CommonOptions& common) {
    const Stopwatch watch;
    ArmParts parts;
    parts.scene = read_scene_for(options, kernels);
    check_trust(parts.scene, options.trust_scene_kernels);
    parts.parse_seconds = watch.seconds();
    parts.pack.models = read_brdf_tables(kernels);
    if (!try_user_models(device, kernels, parts.pack.models, common)) return {};
    parts.pack.all_features = options.features == "all";
    parts.pack.integrator = options.integrator;
    return parts;
}

std::unique_ptr<Arm> open_arm(const std::string& name, const Device& device, KernelText& kernels,
                              const SceneOptions& options, const CommonOptions& common) {
    const auto parts = read_arm(device, kernels, options, common);
    if (!parts) return nullptr;
    return std::make_unique<Arm>(name, device, kernels, parts->scene, parts->pack,
                                 parts->parse_seconds);
}

}  // namespace lobe
