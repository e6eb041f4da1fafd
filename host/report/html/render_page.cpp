// SPDX-License-Identifier: Apache-2.0
#include "report/html/render_page.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "base/statistics.h"
#include "report/html/costs.h"
#include "report/html/pictures.h"
#include "report/way_on.h"

namespace lobe {
namespace {

constexpr std::uint32_t most_shown = 700;

std::string digits(double value, const char* format = "%.4g") {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// The mean with its 95 % interval.
std::string with_interval(double mean, const std::optional<double>& standard_error) {
    if (!standard_error) return digits(mean) + ", error unknown";
    const double half = normal_quantile(0.975) * *standard_error;
    return digits(mean) + " (95 %: " + digits(mean - half, "%.5g") + " to " +
           digits(mean + half, "%.5g") + ")";
}

std::string headline(const RenderReport& r) {
    std::string text = "The picture's relative standard error is " + error_text(r.picture) +
                       " after " + digits(r.picture.mean_samples) + " samples a pixel and " +
                       seconds_text(r.seconds.render) + " of rendering.";
    if (r.partial) text += " It was stopped early.";
    return text;
}

ReportSection picture_section(const RenderReport& r, double exposure) {
    ReportSection section;
    section.heading = "Picture";
    const PictureView view = view_of(r.picture);
    ReportViewer viewer;
    viewer.exposure = exposure;
    viewer.pictures.push_back(linear_picture("picture", view));
    if (!r.picture.standard_error.empty())
        viewer.pictures.push_back(standard_error_picture("standard error", view));
    const std::uint32_t width = std::min(r.width, most_shown),
                        height = std::min(r.height, most_shown);
    viewer.caption = std::to_string(r.width) + " by " + std::to_string(r.height) + " pixels";
    if (width < r.width || height < r.height)
        viewer.caption +=
            "; shown is the middle, " + std::to_string(width) + " by " + std::to_string(height);
    for (ReportPicture& p : viewer.pictures)
        p.image = cropped(p.image, (r.width - width) / 2, (r.height - height) / 2, width, height);
    section.viewers.push_back(viewer);
    return section;
}

ReportSection error_section(const RenderReport& r) {
    ReportSection section;
    section.heading = "Error";
    const Estimate& e = r.picture;
    section.facts = {
        {"Relative standard error", error_text(e)},
        {"Mean luminance", with_interval(e.mean, e.mean_standard_error)},
        {"With lights seen directly", with_interval(e.image_mean, e.image_mean_standard_error)},
        {"Pixels left out", std::to_string(e.masked) + ", in which a light is seen directly"},
        {"Replicates", std::to_string(e.replicates)}};
    if (r.tail) section.facts.emplace_back("Tail index", digits(r.tail->alpha));
    if (r.status) {
        section.facts.emplace_back("Samples not finite", std::to_string(r.status->nonfinite()));
        section.facts.emplace_back("Samples negative", std::to_string(r.status->negative()));
    }
    if (!e.relative_standard_error) return section;
    if (const auto way = way_on(*e.relative_standard_error, r.seconds.render, r.command))
        section.paragraphs.push_back("An error of " + percent_text(way->error) + " needs about " +
                                     seconds_text(way->more_seconds) + " more: " + way->command);
    return section;
}

}  // namespace

ReportPage render_report_page(const RenderReport& r, double exposure) {
    ReportPage page;
    page.title = "Render of " + std::filesystem::path(r.scene).filename().string();
    page.headline = headline(r);
    page.sections = {picture_section(r, exposure), error_section(r),
                     cost_section({{"this run", r.seconds}})};
    ReportEnvironment& e = page.environment;
    e.version = r.version;
    e.device = r.device;
    e.seed = std::to_string(r.seed);
    e.command = r.command;
    e.more = {{"Scene", r.scene},
              {"Scene hash", r.scene_hash},
              {"Picture hash", r.hash},
              {"Triangles", std::to_string(r.triangles)},
              {"Spheres", std::to_string(r.spheres)},
              {"Lights", std::to_string(r.lights)}};
    e.kernels = {{"", r.features, r.models}};
    return page;
}

std::string render_page(const RenderReport& report, ImageIo& images, double exposure) {
    return to_html(render_report_page(report, exposure), images);
}

}  // namespace lobe
