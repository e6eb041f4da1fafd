// SPDX-License-Identifier: Apache-2.0
#include "cl/source.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "base/kernel_text.h"

namespace lobe {

namespace {

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string quoted(const std::string& name) {
    std::string out = "\"";
    for (const char c : name) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

// The name and the rest of a preprocessor line: {"include", "\"x\""}; empty where it is none.
struct Directive {
    std::string name, rest;
};

Directive parse_directive(const std::string& line) {
    std::size_t at = line.find_first_not_of(" \t");
    if (at == std::string::npos || line[at] != '#') return {};
    at = line.find_first_not_of(" \t", at + 1);
    if (at == std::string::npos) return {};
    const std::size_t end = std::min(line.find_first_of(" \t\"<", at), line.size());
    const std::size_t rest = std::min(line.find_first_not_of(" \t", end), line.size());
    return {line.substr(at, end - at), line.substr(rest)};
}

// Whether a comment is open at the end of a line, given whether one was at its beginning.
bool comment_open_after(const std::string& line, bool open) {
    bool in_string = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (open) {
            if (line.compare(i, 2, "*/") == 0) open = false, ++i;
        } else if (line[i] == '\\') {
            ++i;
        } else if (line[i] == '"') {
            in_string = !in_string;
        } else if (!in_string && line.compare(i, 2, "//") == 0) {
            return false;
        } else if (!in_string && line.compare(i, 2, "/*") == 0) {
            open = true, ++i;
        }
    }
    return open;
}

class Flattener {
  public:
    Flattener(const KernelText& kernels, const std::map<std::string, std::string>& generated)
        : kernels_(kernels), generated_(generated) {}

    void add(const std::string& path, bool conditional, const std::string& where) {
        const std::string text = read(path, where);
        if (std::find(stack_.begin(), stack_.end(), path) != stack_.end()) return;  // its guard
        // What an #if may leave out does not count as included.
        if (!ends_with(path, ".def") && !conditional && !seen_.insert(path).second) return;
        if (!ends_with(path, ".def") && conditional && seen_.count(path)) return;
        stack_.push_back(path);
        out_ << "#line 1 " << quoted(path) << '\n';
        add_lines(path, text, conditional);
        stack_.pop_back();
    }

    std::string text() const { return out_.str(); }

  private:
    std::string read(const std::string& path, const std::string& where) const {
        const auto found = generated_.find(path);
        if (found != generated_.end()) return found->second;
        if (kernels_.has(path)) return kernels_.read(path);
        if (neighbours_.count(path)) return read_file(path, ExitCode::scene);
        const std::string near = nearest_name(path, kernels_.list(""));
        const bool own = !stack_.empty() && is_own(stack_.back());
        throw Error(own ? ExitCode::scene : ExitCode::device,
                    "there is no kernel file " + quoted(path) + (own ? ", nor one beside it" : ""),
                    where,
                    near.empty() ? "kernel files are named from the root of kernels/"
                                 : "did you mean " + quoted(near) + "?");
    }

    bool is_own(const std::string& path) const {
        return kernels_.added(path) || neighbours_.count(path);
    }

    // What a file means by a name: a kernel, or for a user's own file one that lies beside it.
    std::string resolve(const std::string& name, const std::string& from) {
        const bool kernel = kernels_.has(name) && !kernels_.added(name);
        if (generated_.count(name) || kernel || !is_own(from)) return name;
        const std::filesystem::path beside = std::filesystem::path(from).parent_path() / name;
        std::error_code error;
        if (!std::filesystem::is_regular_file(beside, error)) return name;
        return *neighbours_.insert(beside.string()).first;
    }

    void add_lines(const std::string& path, const std::string& text, bool conditional) {
        std::istringstream lines(text);
        std::string line, last;
        unsigned number = 0, depth = 0, guard_depth = 0, directives = 0;
        bool comment = false;
        while (std::getline(lines, line)) {
            ++number;
            if (!line.empty() && line.back() == '\r') line.pop_back();
            const Directive directive = comment ? Directive{} : parse_directive(line);
            comment = comment_open_after(line, comment);
            if (!directive.name.empty()) ++directives;
            if (directive.name.compare(0, 2, "if") == 0) ++depth;
            if (directive.name == "endif" && depth) --depth;
            // `#ifndef X` and `#define X` as the first two: the file's guard, not a choice
            if (directives == 1 && directive.name == "ifndef") last = directive.rest;
            if (directives == 2 && directive.name == "define" && !last.empty() &&
                directive.rest.compare(0, last.size(), last) == 0)
                guard_depth = 1;
            // An include in <> is C++'s, in a header that both languages read.
            if (directive.name != "include" || directive.rest[0] == '<') {
                out_ << line << '\n';
                continue;
            }
            const std::string where =
                path + ":" + std::to_string(number) + ":" + std::to_string(line.find('#') + 1);
            add(resolve(included_name(directive.rest, where), path),
                conditional || depth > guard_depth, where);
            out_ << "#line " << number + 1 << ' ' << quoted(path) << '\n';
        }
    }

    static std::string included_name(const std::string& rest, const std::string& where) {
        const std::size_t end = rest.find('"', 1);
        if (rest.empty() || rest[0] != '"' || end == std::string::npos)
            throw Error(ExitCode::device, "this include cannot be read: " + rest, where,
                        "write #include \"folder/file.h\", named from the root of kernels/");
        return rest.substr(1, end - 1);
    }

    const KernelText& kernels_;
    const std::map<std::string, std::string>& generated_;
    std::set<std::string> neighbours_;  // files beside the user's own
    std::set<std::string> seen_;
    std::vector<std::string> stack_;
    std::ostringstream out_;
};

}  // namespace

std::string flatten(const KernelText& kernels, const std::string& path,
                    const std::map<std::string, std::string>& generated) {
    Flattener flattener(kernels, generated);
    flattener.add(path, false, "");
    return flattener.text();
}

}  // namespace lobe
