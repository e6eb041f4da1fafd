// SPDX-License-Identifier: Apache-2.0
#include "scene/user_model.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "scene/materials.h"
#include "scene/source.h"

namespace lobe {

namespace {

std::string plain(const std::string& name) {
    std::string out;
    for (const char c : name)
        if (c != '_') out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

// A path that no kernel file has: where a user's own folder looks like lobe's, "./brdf/lobe.h".
std::string distinct_path(const std::string& file) {
    const std::filesystem::path path(file);
    return path.is_relative() && path.begin()->string() == "brdf" ? "./" + file : file;
}

[[noreturn]] void refuse_name(const UserModel& model, const std::string& owner,
                              const std::string& hint) {
    const auto source = make_source(model.table.file, model.text);
    const Place place{source.get(), source->text.find(model.table.name + "_parameters(P)")};
    fail(place, "the name '" + model.table.name + "' is taken by " + owner, hint);
}

}  // namespace

bool same_model_name(const std::string& a, const std::string& b) { return plain(a) == plain(b); }

UserModel read_user_model(const std::string& file, const std::vector<BrdfTable>& models) {
    if (printable(file) != file || file.find_first_of("\"\\") != std::string::npos)
        throw Error(ExitCode::scene,
                    "a kernel's file name has a character that kernels cannot name", file,
                    "rename the file");
    UserModel model;
    model.text = read_file(file);
    if (model.text.compare(0, 3, "\xef\xbb\xbf") == 0) model.text.erase(0, 3);
    if (model.text.find('\0') != std::string::npos)
        throw Error(ExitCode::scene, "a kernel is plain text, and this file has a NUL byte", file);
    model.table = parse_brdf_table(distinct_path(file), model.text);
    model.table.own = true;
    const std::string hint = "give the model of " + file +
                             " another name, in its table and in all "
                             "its functions";
    for (const BrdfTable& other : models)
        if (same_model_name(other.name, model.table.name))
            refuse_name(model, (other.own ? "the model of " : "lobe's own ") + other.file, hint);
    if (is_pbrt_material(model.table.name)) refuse_name(model, "a material of pbrt", hint);
    return model;
}

const BrdfTable* find_user_model(const std::vector<BrdfTable>& models, const std::string& file) {
    for (const BrdfTable& table : models) {
        std::error_code error;
        if (table.own &&
            (table.file == file || std::filesystem::equivalent(table.file, file, error)))
            return &table;
    }
    return nullptr;
}

}  // namespace lobe
