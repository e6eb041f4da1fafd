// SPDX-License-Identifier: Apache-2.0
#include "app/usage.h"

namespace lobe {
namespace {

std::vector<std::string> option_names(const CLI::App& verb) {
    std::vector<std::string> names;
    for (const CLI::Option* option : verb.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> verb_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(verb->get_name());
    return names;
}

std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

Error usage(const std::string& what, const std::string& nearest, const std::string& hint) {
    return Error(ExitCode::usage, what, "",
                 nearest.empty() ? hint : "did you mean '" + nearest + "'? " + hint);
}

// "--spp=4" -> "--spp"
std::string name_of(const std::string& word) { return word.substr(0, word.find('=')); }

}  // namespace

Error usage_error(const CLI::App& app, const CLI::ParseError& fault) {
    const std::vector<CLI::App*> given = app.get_subcommands();
    const std::vector<std::string> unexpected = app.remaining(true);
    if (given.empty()) {
        const std::string hint = "choose one of: " + list(verb_names(app)) + "; see `lobe --help`";
        if (unexpected.empty()) return usage("a verb is missing", "", hint);
        const std::string& word = unexpected.front();
        const bool option = word[0] == '-';
        return usage((option ? "unknown option '" : "unknown verb '") + word + "'",
                     option ? "" : nearest_name(word, verb_names(app)), hint);
    }
    const CLI::App& verb = *given.front();
    const std::string hint = "see `lobe " + verb.get_name() + " --help`";
    for (const std::string& word : unexpected)
        if (word.size() > 1 && word[0] == '-')
            return usage("unknown option '" + word + "'",
                         nearest_name(name_of(word), option_names(verb)), hint);
    if (!unexpected.empty())
        return usage("one argument too many: '" + unexpected.front() + "'", "", hint);
    return usage(fault.what(), "", hint);
}

}  // namespace lobe
