// SPDX-License-Identifier: Apache-2.0
// Camera samples of one pixel on the device (kernels/probe/camera.cl).
#pragma once

#include <array>
#include <vector>

#include "build/filter.h"
#include "build/pack.h"
#include "support/probe.h"

namespace lobe::test {

using CameraNumbers = std::array<float, 4>;  // two for the film, two for the lens

struct CameraSample {
    glm::vec2 film;
    float weight;
    glm::vec3 origin, direction;
};

class CameraRig {
  public:
    // With all features compiled in, or with those that the scene needs.
    explicit CameraRig(const Scene& scene, bool all = true)
        : packed_(pack_scene(scene)),
          filter_(tabulate_filter(scene.filter).nodes),
          program_(
              build_probe("probe/camera.cl",
                          {{"lobe_scene.h",
                            scene_header(all ? all_features() : derive_features(scene), {})}})) {}

    const PackedScene& packed() const { return packed_; }

    std::vector<CameraSample> sample(const glm::uvec2& pixel,
                                     const std::vector<CameraNumbers>& numbers) const {
        std::vector<float> in;
        for (const CameraNumbers& n : numbers) in.insert(in.end(), n.begin(), n.end());
        Buffer<float> out(test_device(), 9 * numbers.size());
        run_probe(program_, "camera_rays", numbers.size(),
                  Buffer<LobeFrame>(test_device(), std::vector<LobeFrame>{packed_.frame}),
                  Buffer<float>(test_device(), filter_), cl_uint(pixel.x), cl_uint(pixel.y),
                  Buffer<float>(test_device(), in), out);
        const std::vector<float> n = out.read_all();
        std::vector<CameraSample> samples;
        for (std::size_t i = 0; i < n.size(); i += 9)
            samples.push_back({{n[i], n[i + 1]},
                               n[i + 2],
                               {n[i + 3], n[i + 4], n[i + 5]},
                               {n[i + 6], n[i + 7], n[i + 8]}});
        return samples;
    }

  private:
    PackedScene packed_;
    std::vector<float> filter_;
    Program program_;
};

}  // namespace lobe::test
