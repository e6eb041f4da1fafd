// SPDX-License-Identifier: Apache-2.0
// lobe brdf new: a model of one's own to start from.
#include <sys/stat.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/brdf_command.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "scene/materials.h"
#include "scene/user_model.h"

namespace lobe {
namespace {

struct Options {
    CommonOptions common;
    std::string name, output;
};

// The name becomes a part of the names of functions.
void check_name(const std::string& name, const std::vector<BrdfTable>& models) {
    static const std::regex form("[a-z][a-z0-9_]*");
    if (!std::regex_match(name, form) || name.size() > 64)
        throw Error(ExitCode::usage, "a model cannot be called '" + name + "'", "",
                    "a name is a small letter, then small letters, digits and _, as in velvet_2");
    for (const BrdfTable& table : models)
        if (same_model_name(table.name, name))
            throw Error(ExitCode::usage,
                        "the name '" + name + "' is taken by lobe's own " + table.file, "",
                        "choose another name");
    if (is_pbrt_material(name))
        throw Error(ExitCode::usage, "the name '" + name + "' is taken by a material of pbrt", "",
                    "choose another name");
}

// The template with its name filled in. Its licence line stays behind: the file is the user's.
std::string filled(std::string text, const std::string& name) {
    text.erase(0, text.find('\n') + 1);
    for (std::size_t at = 0; (at = text.find("NAME", at)) != std::string::npos; at += name.size())
        text.replace(at, 4, name);
    return text;
}

int run(const Options& options) {
    set_quiet(options.common.quiet);
    const KernelText kernels = open_kernels(options.common);
    check_name(options.name, read_brdf_tables(kernels));
    const std::string file = options.output.empty() ? options.name + ".cl" : options.output;
    struct stat status;
    if (lstat(file.c_str(), &status) == 0)
        throw Error(ExitCode::output, "there is such a file already", file,
                    "it is left as it is: choose another with -o");
    write_file(file, filled(kernels.read("brdf/template.cl"), options.name));
    if (options.common.json != "-" && !options.common.quiet)
        std::printf(
            "model    %s in %s\n"
            "check    lobe brdf check %s\n"
            "render   lobe render --brdf %s SCENE, where the scene has Material \"%s\"\n",
            options.name.c_str(), file.c_str(), file.c_str(), file.c_str(), options.name.c_str());
    if (!options.common.json.empty()) {
        const nlohmann::ordered_json json = {{"model", options.name}, {"file", file}};
        write_json(options.common.json, json.dump(2) + "\n");
    }
    return 0;
}

}  // namespace

Command add_brdf_new(CLI::App& verb) {
    CLI::App* fresh = verb.add_subcommand("new", "write a model of your own to start from");
    auto options = std::make_shared<Options>();
    fresh->add_option("name", options->name, "of the model: small letters, digits and _")
        ->required()
        ->type_name("NAME");
    fresh->add_option("-o,--output", options->output, "file to write (NAME.cl)")->type_name("FILE");
    add_common_options(*fresh, options->common);
    return [options] { return run(*options); };
}

}  // namespace lobe
