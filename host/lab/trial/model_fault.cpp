// SPDX-License-Identifier: Apache-2.0
#include "lab/trial/model_fault.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <string>
#include <vector>

#include "base/kernel_text.h"
#include "cl/source.h"

namespace lobe {
namespace {

// "velvet.cl:12:5" -> "velvet.cl"
std::string file_of(std::string where) {
    for (int i = 0; i < 2; ++i) {
        const std::size_t colon = where.rfind(':');
        const bool number = colon != std::string::npos && colon + 1 < where.size() &&
                            where.find_first_not_of("0123456789", colon + 1) == std::string::npos;
        if (number) where.resize(colon);
    }
    return where;
}

// Whether an added text, or a file beside it that it includes, has this name.
bool is_users(const std::string& file, const KernelText& kernels) {
    if (file.empty() || (kernels.has(file) && !kernels.added(file))) return false;
    for (const std::string& path : kernels.list(""))
        if (kernels.added(path) &&
            flatten(kernels, path).find("#line 1 \"" + file + "\"\n") != std::string::npos)
            return true;
    return false;
}

std::string without_comments(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        if (text.compare(i, 2, "//") == 0) {
            end = text.find('\n', i);
        } else if (text.compare(i, 2, "/*") == 0) {
            end = text.find("*/", i + 2);
            if (end != std::string::npos) end += 2;
            out += ' ';
        } else {
            out += text[i++];
            continue;
        }
        i = std::min(end, text.size());
    }
    return out;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Whether a function of that name has a body in the text: its name, (...) and {.
bool defines(const std::string& text, const std::string& function) {
    const auto skip_blanks = [&](std::size_t at) {
        while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at]))) ++at;
        return at;
    };
    for (std::size_t at = text.find(function); at != std::string::npos;
         at = text.find(function, at + 1)) {
        std::size_t end = at + function.size();
        if ((at > 0 && is_word(text[at - 1])) || (end < text.size() && is_word(text[end])))
            continue;
        end = skip_blanks(end);
        if (end >= text.size() || text[end] != '(') continue;
        end = text.find(')', end);
        if (end == std::string::npos) continue;
        end = skip_blanks(end + 1);
        if (end < text.size() && text[end] == '{') return true;
    }
    return false;
}

struct Wanted {
    std::string name, form;
};

std::vector<Wanted> functions_of(const std::string& n) {
    return {
        {"_prepare", n + "_prepared " + n + "_prepare(" + n + "_values values)"},
        {"_claims", "int " + n + "_claims(" + n + "_values values)"},
        {"_eval", "real3 " + n + "_eval(const " + n + "_prepared* m, real3 wo, real3 wi)"},
        {"_pdf", "real " + n + "_pdf(const " + n + "_prepared* m, real3 wo, real3 wi)"},
        {"_sample", "BrdfSample " + n + "_sample(const " + n + "_prepared* m, real3 wo, real3 u)"}};
}

Error missing(const BrdfTable& model, const std::string& what, const std::string& form) {
    return Error(ExitCode::scene, "the model has no " + what, model.file,
                 "write " + form + ", as kernels/brdf/README.md tells");
}

}  // namespace

Error users_fault(const Error& error, const KernelText& kernels) {
    const bool users = is_users(file_of(error.where()), kernels);
    return Error(users ? ExitCode::scene : error.code(), error.what(), error.where(), error.hint());
}

Error build_fault(const Error& error, const KernelText& kernels, const BrdfTable& model) {
    // The driver's own trouble has no place; a file that is missing is told already.
    if (error.where().empty() || error.code() == ExitCode::scene) return error;
    const std::string text = without_comments(flatten(kernels, model.file));
    const auto has = [&](const std::string& form) {
        return std::regex_search(text, std::regex(form));
    };
    if (!has("LOBE_BRDF_VALUES\\s*\\(\\s*" + model.name + "\\s*\\)"))
        return missing(model, "LOBE_BRDF_VALUES(" + model.name + ")", "it after the table");
    if (!has("\\b" + model.name + "_prepared\\s*;"))
        return missing(model, model.name + "_prepared",
                       "typedef struct { ... } " + model.name + "_prepared;");
    for (const Wanted& wanted : functions_of(model.name))
        if (!defines(text, model.name + wanted.name))
            return missing(model, model.name + wanted.name, wanted.form);
    if (is_users(file_of(error.where()), kernels)) return users_fault(error, kernels);
    return Error(
        ExitCode::scene,
        "the model does not fit where lobe uses it (" + error.where() + "): " + error.what(),
        model.file, error.hint());
}

}  // namespace lobe
