// SPDX-License-Identifier: Apache-2.0
// lobe brdf fit: models' parameters for a file of measured reflectance, and which model suits it
// best.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/lab_options.h"
#include "app/numbers.h"
#include "base/error.h"
#include "base/log.h"
#include "base/signals.h"
#include "lab/fit/fit.h"
#include "lab/fit/least_squares.h"
#include "lab/parameter_sweep.h"
#include "scene/measured_files.h"

namespace lobe {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    LabOptions lab;
    std::string file, weight = "cos";
    FitOptions fit;
};

struct Fitted {
    const Subject* subject;
    ModelFit fit;

    double error(FitWeight weight) const {
        return weight == FitWeight::cosine ? fit.cosine_error : fit.log_error;
    }
};

// Names of the model's parameters that --set gives.
std::vector<std::string> held_of(const std::vector<std::string>& settings, const BrdfTable& model) {
    std::vector<std::string> names;
    for (const std::string& text : settings) {
        const Setting s = parse_setting(text);
        if (s.model.empty() || s.model == model.name) names.push_back(s.name);
    }
    return names;
}

void refuse_tables(const BrdfTable& model, const std::vector<std::string>& held) {
    for (const BrdfParameter& p : model.parameters)
        if (p.kind == BrdfParameterKind::table &&
            std::find(held.begin(), held.end(), p.name) == held.end())
            throw Error(ExitCode::usage, model.name + " is a table itself and has none to fit with",
                        "", "name its file: --set " + model.name + "." + p.name + "=FILE");
}

// Three numbers that are one are said once.
std::string numbers_text(const std::vector<double>& numbers) {
    std::string text;
    for (const double v : numbers) text += (text.empty() ? "" : " ") + short_number(v);
    return text;
}

std::string error_text(const std::vector<double>& errors) {
    std::string text;
    for (const double v : errors) {
        char word[32];
        std::snprintf(word, sizeof word, "%.2g", v);
        text += (text.empty() ? "" : " ") + (std::isnan(v) ? std::string("-") : word);
    }
    return text;
}

void print_model(const Fitted& fitted) {
    std::string name = fitted.subject->model.name;
    for (const FittedParameter& p : fitted.fit.parameters) {
        std::printf("%-16s  %-15s %-24s +- %s\n", name.c_str(), p.name.c_str(),
                    numbers_text(p.value).c_str(), error_text(p.standard_error).c_str());
        name.clear();
    }
    if (!fitted.fit.converged) std::printf("%-16s  not converged\n", "");
}

void print_errors(const std::vector<Fitted>& all, const Fitted& best, double size) {
    std::printf("\n%-16s  %12s  %9s  %10s\n", "model", "cos error", "of data", "log error");
    for (const Fitted& fitted : all)
        std::printf("%-16s  %12s  %7.2f %%  %10s%s\n", fitted.subject->model.name.c_str(),
                    short_number(fitted.fit.cosine_error).c_str(),
                    100 * fitted.fit.cosine_error / size,
                    short_number(fitted.fit.log_error).c_str(),
                    &fitted == &best && all.size() > 1 ? "  wins" : "");
}

Json to_json(const Fitted& fitted, double size) {
    Json parameters = Json::array();
    const auto number = [](double v) { return std::isnan(v) ? Json(nullptr) : Json(v); };
    for (const FittedParameter& p : fitted.fit.parameters) {
        Json values = Json::array(), errors = Json::array();
        for (const double v : p.value) values.push_back(v);
        for (const double v : p.standard_error) errors.push_back(number(v));
        const bool one = p.value.size() == 1;
        parameters.push_back({{"name", p.name},
                              {"value", one ? values[0] : values},
                              {"standard_error", one ? errors[0] : errors}});
    }
    return {{"model", fitted.subject->model.name},
            {"cos_error", fitted.fit.cosine_error},
            {"cos_error_relative", fitted.fit.cosine_error / size},
            {"log_error", fitted.fit.log_error},
            {"parameters", parameters},
            {"converged", fitted.fit.converged},
            {"iterations", fitted.fit.iterations},
            {"fit_s", fitted.fit.seconds}};
}

void print_heading(const Options& options, const MeasuredBrdf& table, const FitPoints& points) {
    std::printf(
        "%s: %u x %u x %u cells; %zu of the %zu with data up to %g degrees off the normal\n",
        options.file.c_str(), table.counts[0], table.counts[1], table.counts[2], points.size(),
        points.candidates, options.fit.largest_angle);
    std::printf("least squares of %s, c = sqrt(cos theta_i cos theta_o)\n\n",
                options.fit.weight == FitWeight::cosine
                    ? "c (data - model)"
                    : "ln (0.001 + c data) - ln (0.001 + c model)");
}

int run(Options options) {
    need_least_squares();
    options.fit.weight = options.weight == "cos" ? FitWeight::cosine : FitWeight::logarithm;
    if (options.lab.models.empty()) options.lab.models = {"rational", "phong", "modified_phong"};
    const MeasuredBrdf table = read_measured(options.file);
    const FitPoints points = choose_points(table, options.fit);
    const std::optional<Lab> lab = open_lab(options.lab);
    if (!lab) return stop_exit_code();
    for (const Subject& subject : lab->subjects)
        refuse_tables(subject.model, held_of(options.lab.settings, subject.model));
    const bool show = options.lab.common.json != "-";
    const double size = size_of(points);
    std::vector<Fitted> all;
    for (const Subject& subject : lab->subjects) {
        if (stop_signal()) return stop_exit_code();
        note("fitting " + subject.model.name);
        BrdfProbe probe = lab->precise_probe(subject);
        all.push_back(
            {&subject, fit_model(probe, subject, held_of(options.lab.settings, subject.model),
                                 points, options.fit)});
        if (show && all.size() == 1) print_heading(options, table, points);
        if (show) print_model(all.back());
    }
    const Fitted& best =
        *std::min_element(all.begin(), all.end(), [&](const Fitted& a, const Fitted& b) {
            return a.error(options.fit.weight) < b.error(options.fit.weight);
        });
    if (show) print_errors(all, best, size);
    Json json = {{"file", options.file},
                 {"device", lab->device.info().name},
                 {"counts", table.counts},
                 {"cells_with_data", points.candidates},
                 {"points", points.size()},
                 {"largest_angle_degrees", options.fit.largest_angle},
                 {"weight", options.weight},
                 {"seed", options.fit.seed},
                 {"data_rms", size},
                 {"models", Json::array()},
                 {"wins", best.subject->model.name}};
    for (const Fitted& fitted : all) json["models"].push_back(to_json(fitted, size));
    if (!options.lab.common.json.empty()) write_json(options.lab.common.json, json.dump(2) + "\n");
    return static_cast<int>(ExitCode::ok);
}

}  // namespace

Command add_brdf_fit(CLI::App& verb) {
    CLI::App* fit = verb.add_subcommand("fit", "models' parameters for measured reflectance");
    auto options = std::make_shared<Options>();
    fit->add_option("file", options->file, "a table in MERL's binary layout or lobe's text")
        ->required()
        ->type_name("FILE");
    fit->add_option("--model", options->lab.models,
                    "a model, or a file of your own; may be repeated (rational, phong and "
                    "modified_phong)")
        ->type_name("NAME|FILE|all");
    fit->add_option("--set", options->lab.settings,
                    "a parameter that is given, of one model or of all that have it")
        ->type_name("[MODEL.]NAME=VALUE");
    fit->add_option("--weight", options->weight,
                    "what is made least: cos, the error of what is reflected, or log, of ratios")
        ->check(CLI::IsMember({"cos", "log"}));
    fit->add_option("--points", options->fit.points, "use at most so many cells")
        ->transform(whole_number(10, 10000000));
    fit->add_option("--angle", options->fit.largest_angle,
                    "leave out directions further from the normal, degrees")
        ->check(real_number(1, 89.9, "from 1 to 89.9"));
    fit->add_option("--seed", options->fit.seed, "of the choice of cells and of the starts");
    add_common_options(*fit, options->lab.common);
    return [options] { return run(*options); };
}

}  // namespace lobe
