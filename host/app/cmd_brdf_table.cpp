// SPDX-License-Identifier: Apache-2.0
// lobe brdf table: what models reflect, in numbers; and one model's parameter matched to another's.
#include <cstdio>
#include <limits>
#include <memory>

#include "app/lab_options.h"
#include "app/numbers.h"
#include "base/error.h"
#include "base/log.h"
#include "base/signals.h"
#include "lab/page/match_report.h"
#include "lab/page/model_table.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    LabOptions lab;
    std::vector<double> angles = {0, 30, 45, 60, 75, 85}, at;
    double azimuth = 0;
    std::string match;
    std::vector<std::string> vary;
};

void show(const Options& options, const std::string& text) {
    if (options.lab.common.json != "-") std::fputs(text.c_str(), stdout);
}

Json match(const Options& options, const Lab& lab) {
    Json all = Json::array();
    const Subject& target = lab.subjects.back();
    BrdfProbe their_probe = lab.precise_probe(target);
    const Sharpened other =
        find_sharpness(their_probe, target, named_for(options.vary, target.model.name));
    const std::vector<double> values = options.at.empty() ? other.examples() : options.at;
    for (const double value : values)
        if (!(value >= other.row().lowest && value <= other.row().highest))
            throw Error(ExitCode::usage,
                        "--at " + std::to_string(value) + " is out of the range of " +
                            target.model.name + "'s " + other.name(),
                        "", "lobe brdf list --json - shows the ranges");
    for (std::size_t i = 0; i + 1 < lab.subjects.size(); ++i) {
        const Subject& subject = lab.subjects[i];
        BrdfProbe probe = lab.precise_probe(subject);
        const Sharpened own =
            find_sharpness(probe, subject, named_for(options.vary, subject.model.name));
        const std::vector<Match> matches = match_lobes(own, other, values);
        show(options, (i ? "\n" : "") + to_text(matches, own, other));
        all.push_back(to_json(matches, own, other));
    }
    return all;
}

Json measure(const Options& options, const Lab& lab) {
    Json all = Json::array();
    for (const Subject& subject : lab.subjects) {
        if (stop_signal()) break;
        BrdfProbe probe = lab.probe(subject);
        const ModelTable table =
            measure_model(probe, subject, options.angles, glm::radians(options.azimuth));
        show(options, (all.empty() ? "" : "\n") + to_text(table));
        all.push_back(to_json(table));
    }
    return all;
}

int run(const Options& options) {
    if (options.lab.models.empty())
        throw Error(ExitCode::usage, "no model is named", "", "lobe brdf list names them all");
    const std::vector<std::string> more = options.match.empty()
                                              ? std::vector<std::string>{}
                                              : std::vector<std::string>{options.match};
    const std::optional<Lab> lab = open_lab(options.lab, more);
    if (!lab) return stop_exit_code();
    Json json = {{"device", lab->device.info().name}, {"driver", lab->device.info().driver}};
    if (options.match.empty())
        json["models"] = measure(options, *lab);
    else
        json["matches"] = match(options, *lab);
    if (stop_signal()) return stop_exit_code();
    if (!options.lab.common.json.empty()) write_json(options.lab.common.json, json.dump(2) + "\n");
    return 0;
}

}  // namespace

Command add_brdf_table(CLI::App& verb) {
    CLI::App* table =
        verb.add_subcommand("table", "values, albedo, lobe width; parameters that match");
    auto options = std::make_shared<Options>();
    add_lab_options(*table, options->lab);
    table
        ->add_option("--angles", options->angles, "of view, and of light on both sides, in degrees")
        ->delimiter(',')
        ->check(real_number(0, 90, "from 0 to 90"))
        ->type_name("DEG,...");
    table->add_option("--azimuth", options->azimuth, "of the plane of incidence, in degrees (0)")
        ->check(real_number(-360, 360, "from -360 to 360"))
        ->type_name("DEG");
    table->add_option("--match", options->match, "match the models to this one, by measurement")
        ->type_name("NAME");
    table->add_option("--vary", options->vary, "the parameter that shapes the lobe, if not clear")
        ->type_name("[MODEL.]NAME");
    table->add_option("--at", options->at, "values of that parameter of the model matched to")
        ->delimiter(',')
        ->check(real_number(0, std::numeric_limits<double>::max(), "of its range"))
        ->type_name("VALUE,...");
    return [options] { return run(*options); };
}

}  // namespace lobe
