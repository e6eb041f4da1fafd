// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_files.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"

namespace lobe {

namespace {

namespace fs = std::filesystem;

bool includes_a_file(const Statement& statement) {
    return statement.name == "Include" || statement.name == "Import";
}

// One path for a file, however it is named.
std::string identity(const std::string& path) {
    std::error_code fault;
    const fs::path canonical = fs::weakly_canonical(path, fault);
    return fault ? path : canonical.string();
}

}  // namespace

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }

std::string resolve_path(const std::string& name, const Place& place,
                         const std::string& root_folder) {
    if (name.empty()) fail(place, "an empty file name");
    if (fs::path(name).is_absolute()) return name;
    const std::string near = (fs::path(folder_of(place.file->path)) / name).string();
    const std::string far = (fs::path(root_folder) / name).string();
    std::error_code fault;
    if (fs::exists(near, fault)) return near;
    if (fs::exists(far, fault)) return far;
    fail(place, "no file '" + name + "'",
         near == far ? "looked for " + near : "looked for " + near + " and " + far);
}

std::string show_chain(const std::vector<const ParsedFile*>& chain) {
    std::string text;
    for (std::size_t i = 0; i < chain.size(); ++i)
        text += (i ? " includes " : "") + chain[i]->source->path;
    return text;
}

ParsedFile* SceneFiles::parse(const std::string& path) {
    order_.push_back(std::make_unique<ParsedFile>());
    ParsedFile* const file = order_.back().get();
    by_path_[identity(path)] = file;
    file->source = read_source(path);
    file->statements = parse_statements(*file->source, lenient_, warnings_);
    return file;
}

SceneFiles::SceneFiles(const std::string& path, bool lenient, std::vector<std::string>& warnings)
    : lenient_(lenient), warnings_(warnings) {
    struct Visit {
        ParsedFile* file;
        std::size_t next;
    };
    std::vector<Visit> stack{{parse(path), 0}};
    const std::string root_folder = folder_of(path);
    while (!stack.empty()) {
        Visit& visit = stack.back();
        const auto& statements = visit.file->statements;
        while (visit.next < statements.size() && !includes_a_file(statements[visit.next]))
            ++visit.next;
        if (visit.next == statements.size()) {
            stack.pop_back();
            continue;
        }
        const Word& name = statements[visit.next++].strings[0];
        const std::string file = resolve_path(name.text, name.place, root_folder);
        const auto known = by_path_.find(identity(file));
        ParsedFile* const included = known == by_path_.end() ? parse(file) : known->second;
        visit.file->includes.push_back(included);
        std::vector<const ParsedFile*> chain;
        for (const Visit& parent : stack) chain.push_back(parent.file);
        const bool recursive = std::find(chain.begin(), chain.end(), included) != chain.end();
        chain.push_back(included);
        if (recursive) fail(name.place, "a file that includes itself: " + show_chain(chain));
        if (chain.size() > include_depth_limit)
            fail(name.place, "includes nest deeper than " + std::to_string(include_depth_limit) +
                                 " files: " + show_chain(chain));
        if (known == by_path_.end()) stack.push_back({included, 0});
    }
}

}  // namespace lobe
