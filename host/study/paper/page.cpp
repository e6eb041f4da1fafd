// SPDX-License-Identifier: Apache-2.0
#include "study/paper/page.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "report/error_map.h"

namespace lobe {
namespace {

constexpr std::uint32_t crop_side = 256;
constexpr std::array<const char*, 3> model_names = {"rational", "Phong", "modified Phong"};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string in_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

ReportTable table(const std::string& title, const Rows& rows, const std::string& note = "") {
    return {title, rows.front(), {rows.begin() + 1, rows.end()}, {}, in_one_line(note)};
}

ImageFile cropped(const ImageFile& file, const Crop& crop) {
    ImageFile part = file;
    part.width = part.full_width = crop.width;
    part.height = part.full_height = crop.height;
    part.pixels.clear();
    const std::size_t channels = file.channels.size();
    for (std::uint32_t y = crop.y; y < crop.y + crop.height; ++y) {
        const std::size_t from = (std::size_t{y} * file.width + crop.x) * channels;
        part.pixels.insert(part.pixels.end(), &file.pixels[from],
                           &file.pixels[from] + crop.width * channels);
    }
    return part;
}

// What the viewers show, from one experiment.
class Pictures {
  public:
    explicit Pictures(const PaperExperiment& experiment)
        : e_(experiment),
          crop_(busiest_crop(e_.settings[0].reference.rgb,
                             e_.settings[setting_of(1, Footing::parameters)].reference.rgb,
                             e_.width, e_.height, crop_side)) {}

    std::vector<ReportViewer> viewers() const {
        std::vector<ReportViewer> all;
        all.push_back(viewer("References at equal parameters: what each model looks like.",
                             Footing::parameters, [this](auto& add, Footing f) { truth(add, f); }));
        all.push_back(viewer("References at equal albedo.", Footing::albedo,
                             [this](auto& add, Footing f) { truth(add, f); }));
        all.push_back(viewer("The first run at equal albedo, with two samplers.", Footing::albedo,
                             [this](auto& add, Footing f) {
                                 noisy(add, f, cosine_sampler);
                                 noisy(add, f, best_sampler);
                             }));
        for (const Footing footing : {Footing::parameters, Footing::albedo})
            all.push_back(viewer(std::string("Relative error of the first run at ") +
                                     to_text(footing) +
                                     ": black 0.1 %, blue, red, yellow, white 100 %.",
                                 footing, [this](auto& add, Footing f) {
                                     errors(add, f, cosine_sampler);
                                     errors(add, f, best_sampler);
                                 }));
        return all;
    }

  private:
    using List = std::vector<ReportPicture>;

    template <typename Fill>
    ReportViewer viewer(const std::string& caption, Footing footing, const Fill& fill) const {
        ReportViewer viewer;
        viewer.caption = caption;
        fill(viewer.pictures, footing);
        // A mean of a fifth shows well.
        if (e_.settings[0].mean > 0)
            viewer.exposure = std::clamp(0.2 / e_.settings[0].mean, 0.1, 10.0);
        return viewer;
    }

    ImageFile picture(const std::vector<float>& rgb) const {
        ImageFile file;
        file.width = file.full_width = e_.width;
        file.height = file.full_height = e_.height;
        file.channels = {"R", "G", "B"};
        file.pixels = rgb;
        return cropped(file, crop_);
    }

    const PaperSetting& setting(std::size_t model, Footing footing) const {
        return e_.settings[setting_of(model, footing)];
    }

    void truth(List& list, Footing footing) const {
        for (std::size_t m = 0; m < 3; ++m)
            list.push_back(
                {model_names[m], picture(setting(m, footing).reference.rgb),
                 std::to_string(setting(m, footing).reference.samples) + " samples a pixel"});
    }

    void noisy(List& list, Footing footing, std::size_t sampler) const {
        for (std::size_t m = 0; m < 3; ++m)
            list.push_back({std::string(model_names[m]) + ", " + paper_samplers[sampler].name,
                            picture(setting(m, footing).cells[sampler].picture),
                            paper_samplers[sampler].meaning});
    }

    void errors(List& list, Footing footing, std::size_t sampler) const {
        for (std::size_t m = 0; m < 3; ++m) {
            const PaperSetting& s = setting(m, footing);
            PictureView run, reference = view_of(s.reference);
            run.width = e_.width;
            run.height = e_.height;
            run.rgb = &s.cells[sampler].picture;
            list.push_back({std::string(model_names[m]) + ", " + paper_samplers[sampler].name,
                            cropped(false_colour_error(run, reference), crop_), ""});
        }
    }

    const PaperExperiment& e_;
    Crop crop_;
};

bool has_pictures(const PaperExperiment& e) {
    if (e.rounds == 0) return false;
    for (const PaperSetting& setting : e.settings)
        for (const PaperCell& cell : setting.cells)
            if (cell.picture.empty()) return false;
    return true;
}

ReportEnvironment environment_of(const PaperReport& report) {
    ReportEnvironment all;
    all.version = report.version;
    all.device = report.device;
    all.seed = std::to_string(report.plan.first_seed) + " to " +
               std::to_string(report.plan.first_seed + report.plan.runs - 1);
    all.command = report.command;
    all.more = {{"scene hash", report.scene_hash},
                {"seconds of the references", std::to_string(report.experiment.reference_seconds)},
                {"seconds of the runs", std::to_string(report.experiment.run_seconds)},
                {"seconds in all", std::to_string(report.total_seconds)}};
    for (std::size_t m = 0; m < 3 && m < report.experiment.settings.size(); ++m)
        all.kernels.push_back({model_names[m], report.experiment.settings[m].features,
                               report.experiment.settings[m].models});
    return all;
}

}  // namespace

// Where a window of `side` may begin: every 16 pixels, and at the end.
static std::vector<std::uint32_t> places(std::uint32_t size, std::uint32_t side) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t at = 0; at + side < size; at += 16) all.push_back(at);
    all.push_back(size - side);
    return all;
}

Crop busiest_crop(const std::vector<float>& a, const std::vector<float>& b, std::uint32_t width,
                  std::uint32_t height, std::uint32_t side) {
    const Crop size{0, 0, std::min(side, width), std::min(side, height)};
    // sums[y][x]: of all pixels above and to the left.
    std::vector<double> sums(std::size_t{width + 1} * (height + 1));
    const auto sum = [&](std::uint32_t x, std::uint32_t y) -> double& {
        return sums[std::size_t{y} * (width + 1) + x];
    };
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            double here = 0;
            for (std::size_t i = 3 * (std::size_t{y} * width + x), k = 0; k < 3; ++k)
                here += std::abs(double(a[i + k]) - b[i + k]);
            sum(x + 1, y + 1) = here + sum(x, y + 1) + sum(x + 1, y) - sum(x, y);
        }
    Crop best = size;
    double most = -1;
    for (const std::uint32_t y : places(height, size.height))
        for (const std::uint32_t x : places(width, size.width)) {
            const double inside = sum(x + size.width, y + size.height) - sum(x, y + size.height) -
                                  sum(x + size.width, y) + sum(x, y);
            if (inside <= most) continue;
            most = inside;
            best = {x, y, size.width, size.height};
        }
    return best;
}

ReportPage page_of(const PaperReport& report) {
    ReportPage page;
    page.title = "The paper's table, measured again: " + report.scene;
    page.headline = verdict_sentence(report);
    page.environment = environment_of(report);
    if (report.experiment.rounds > 0) {
        page.table = table("The rational model's error over the others', paired over seeds (95 %)",
                           ratio_rows(report));
        ReportSection experiment;
        experiment.heading = "The experiment";
        experiment.paragraphs = lines_of(conditions_text(report));
        experiment.tables = {
            table("Errors and times", error_rows(report), errors_legend()),
            table("What the materials wear", parameter_rows(report), footings_legend())};
        page.sections.push_back(experiment);
    }
    ReportSection claims;
    claims.heading = "The paper's claims";
    claims.tables = {table("Claims", claim_rows(report))};
    page.sections.push_back(claims);
    if (has_pictures(report.experiment)) {
        ReportSection pictures;
        pictures.heading = "Pictures";
        pictures.paragraphs = {"The part of the film in which the models differ most."};
        pictures.viewers = Pictures(report.experiment).viewers();
        page.sections.push_back(pictures);
    }
    return page;
}

}  // namespace lobe
