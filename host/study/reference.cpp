// SPDX-License-Identifier: Apache-2.0
#include "study/reference.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "base/log.h"
#include "base/progress.h"
#include "cl/binary_cache.h"
#include "render/render.h"
#include "report/image_io.h"
#include "study/reference_file.h"

namespace lobe {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_files = 64;  // older ones are removed

std::string folder() {
    const std::string cache = cache_folder();
    return cache.empty() ? "" : cache + "/references";
}

// "<content hash>-<WxH>-", which the samples and the ending follow.
std::string name_of(const Arm& arm) {
    return arm.content_hash() + "-" + std::to_string(arm.width()) + "x" +
           std::to_string(arm.height()) + "-";
}

struct Kept {
    std::uint32_t samples;
    fs::path path;
};

// What the cache has of this arm, most samples first.
std::vector<Kept> kept_files(const Arm& arm) {
    std::vector<Kept> files;
    const std::string name = name_of(arm);
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder(), error)) {
        const std::string file = entry.path().filename().string();
        if (file.compare(0, name.size(), name) != 0 || entry.path().extension() != ".exr") continue;
        const unsigned long samples = std::strtoul(file.c_str() + name.size(), nullptr, 10);
        files.push_back({static_cast<std::uint32_t>(samples), entry.path()});
    }
    std::sort(files.begin(), files.end(),
              [](const Kept& a, const Kept& b) { return a.samples > b.samples; });
    return files;
}

std::optional<Reference> cached(const Arm& arm, std::uint32_t samples, ImageIo& images) {
    for (const Kept& file : kept_files(arm)) {
        if (file.samples < samples) break;
        try {
            Reference r = checked_reference(images.read(file.path), arm.content_hash());
            if (r.samples < samples || r.width != arm.width() || r.height != arm.height())
                throw Error(ExitCode::scene, "its name says something else");
            r.from_cache = true;
            r.file = file.path;
            return r;
        } catch (const Error& fault) {
            if (fault.code() != ExitCode::scene) throw;  // no image module
            note("the reference kept in " + file.path.string() +
                 " is of no use and rendered anew: " + fault.what());
            std::error_code error;
            fs::remove(file.path, error);
        }
    }
    return {};
}

void remove_old_files() {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (const auto& entry : fs::directory_iterator(folder()))
        if (entry.path().extension() == ".exr")
            files.emplace_back(entry.last_write_time(), entry.path());
    if (files.size() <= most_files) return;
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i < files.size() - most_files; ++i) fs::remove(files[i].second);
}

// A cache that cannot be written is only a slower next run.
void keep(Reference& reference, const Arm& arm, ImageIo& images) {
    if (folder().empty()) return;
    try {
        fs::create_directories(folder());
        const std::vector<Kept> worse = kept_files(arm);
        const std::string path =
            folder() + "/" + name_of(arm) + std::to_string(reference.samples) + ".exr";
        images.write(path, reference_picture(reference, arm.content_hash()));
        reference.file = path;
        for (const Kept& file : worse)
            if (file.samples < reference.samples) fs::remove(file.path);
        remove_old_files();
    } catch (const std::exception& fault) {
        note(std::string("the reference is not kept: ") + fault.what());
    }
}

std::optional<Reference> render_reference(const Device& device, const KernelText& kernels,
                                          const Arm& arm, std::uint32_t samples,
                                          const std::function<bool()>& stop) {
    PackedScene packed = arm.packed();
    packed.integrator = Integrator();
    Session session(device, kernels, packed);
    Reference r;
    r.seed = reference_seed_bit;
    session.set_seed(r.seed);
    RenderPlan plan;
    plan.samples = samples;
    plan.stop = stop;
    Progress shown("reference", "samples");
    plan.progress = [&](const RenderProgress& p) { shown.update(p.samples_done, p.samples_total); };
    const RenderOutcome outcome = render(session, plan);
    if (outcome.stopped) return {};
    if (session.status().trapped())
        throw Error(ExitCode::internal, "the kernel needed what was compiled out", arm.name(),
                    "render with --features all and report this as a fault of lobe");
    Estimate picture = estimate(outcome.film);
    r.width = picture.width;
    r.height = picture.height;
    r.samples = samples;
    r.rgb = std::move(picture.rgb);
    r.standard_error = std::move(picture.standard_error);
    r.luminance_error = std::move(picture.luminance_error);
    r.masked = std::move(picture.sees_light);
    r.seconds = outcome.seconds;
    return r;
}

}  // namespace

std::optional<Reference> reference_of(const Device& device, const KernelText& kernels,
                                      const Arm& arm, std::uint32_t samples, ImageIo& images,
                                      const std::function<bool()>& stop) {
    samples = (std::max(samples, 1u) + LOBE_BLOCK - 1) / LOBE_BLOCK * LOBE_BLOCK;
    std::optional<Reference> reference = cached(arm, samples, images);
    if (!reference) {
        reference = render_reference(device, kernels, arm, samples, stop);
        if (reference) keep(*reference, arm, images);
    }
    if (reference) reference->masked = widened(reference->masked, reference->width);
    return reference;
}

Reference read_reference(const std::string& path, std::uint32_t width, std::uint32_t height,
                         ImageIo& images) {
    try {
        Reference reference = any_reference(images.read(path), width, height);
        reference.file = path;
        reference.masked = widened(reference.masked, width);
        return reference;
    } catch (const Error& fault) {
        if (fault.code() != ExitCode::scene || !fault.where().empty()) throw;
        throw Error(ExitCode::scene, fault.what(), path,
                    "give a picture of the same scene, written with --output FILE.exr");
    }
}

std::vector<bool> widened(const std::vector<bool>& mask, std::uint32_t width) {
    std::vector<bool> wide = mask;
    const auto across = static_cast<std::int64_t>(width);
    const auto down = static_cast<std::int64_t>(mask.size()) / std::max<std::int64_t>(across, 1);
    for (std::int64_t y = 0; y < down; ++y)
        for (std::int64_t x = 0; x < across; ++x) {
            if (!mask[static_cast<std::size_t>(y * across + x)]) continue;
            for (std::int64_t v = std::max<std::int64_t>(y - 1, 0); v <= std::min(y + 1, down - 1);
                 ++v)
                for (std::int64_t u = std::max<std::int64_t>(x - 1, 0);
                     u <= std::min(x + 1, across - 1); ++u)
                    wide[static_cast<std::size_t>(v * across + u)] = true;
        }
    return wide;
}

}  // namespace lobe
