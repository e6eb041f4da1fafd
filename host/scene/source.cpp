// SPDX-License-Identifier: Apache-2.0
#include "scene/source.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "base/files.h"

namespace lobe {

std::string to_string(const Place& place) {
    if (!place.file) return "";
    const auto& starts = place.file->line_starts;
    const auto after = std::upper_bound(starts.begin(), starts.end(), place.offset);
    const std::size_t line = static_cast<std::size_t>(after - starts.begin());
    const std::size_t column = place.offset - starts[line - 1] + 1;
    return place.file->path + ":" + std::to_string(line) + ":" + std::to_string(column);
}

void fail(const Place& place, const std::string& what, const std::string& hint) {
    throw Error(ExitCode::scene, what, to_string(place), hint);
}

void fail_class(const Place& place, const std::string& kind, const std::string& name,
                const std::vector<std::string>& known, const std::vector<std::string>& later) {
    const std::string title = kind + " \"" + name + "\"";
    if (std::find(later.begin(), later.end(), name) != later.end())
        fail(place, title + " is understood but not supported yet", choices(known));
    throw UnknownClass(ExitCode::scene, "unknown " + title, to_string(place),
                       suggestion(name, known));
}

std::string choices(const std::vector<std::string>& names) {
    std::string text = "choose one of: ";
    for (std::size_t i = 0; i < names.size(); ++i) text += (i ? ", " : "") + names[i];
    return text;
}

std::string suggestion(const std::string& name, const std::vector<std::string>& names) {
    if (names.empty()) return "";
    const std::string nearest = nearest_name(name, names);
    return (nearest.empty() ? "" : "did you mean '" + nearest + "'? ") + choices(names);
}

std::string show(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::unique_ptr<SourceFile> make_source(const std::string& path, std::string text) {
    if (text.compare(0, 2, "\x1f\x8b") == 0)
        throw Error(ExitCode::scene, "compressed scene files are not supported", path,
                    "unpack it with gunzip");
    if (text.compare(0, 3, "\xef\xbb\xbf") == 0) text.erase(0, 3);
    auto file = std::make_unique<SourceFile>();
    file->path = path;
    file->text = std::move(text);
    const char* const begin = file->text.data();
    const char* const end = begin + file->text.size();
    file->line_starts.push_back(0);
    for (const char* p = begin; p != end;) {
        p = static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end - p)));
        if (!p) break;
        file->line_starts.push_back(static_cast<std::size_t>(++p - begin));
    }
    const std::size_t zero = file->text.find('\0');
    if (zero != std::string::npos)
        fail({file.get(), zero}, "a NUL byte in a scene file",
             "scene files are plain text; save this one as UTF-8");
    return file;
}

std::unique_ptr<SourceFile> read_source(const std::string& path) {
    return make_source(path, read_file(path, ExitCode::scene));
}

}  // namespace lobe
