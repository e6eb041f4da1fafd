// SPDX-License-Identifier: Apache-2.0
#include "support/meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lobe::test {

namespace {

Mesh icosahedron() {
    const double g = (1 + std::sqrt(5.0)) / 2;
    Mesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (glm::dvec3& p : mesh.positions) p = glm::normalize(p);
    return mesh;
}

}  // namespace

Mesh icosphere(int levels) {
    Mesh mesh = icosahedron();
    for (; levels > 0; --levels) {
        std::map<std::pair<unsigned, unsigned>, unsigned> middles;
        const auto middle = [&](unsigned a, unsigned b) {
            const auto [at, fresh] = middles.emplace(std::minmax(a, b), mesh.positions.size());
            if (fresh)
                mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
            return at->second;
        };
        std::vector<glm::uvec3> finer;
        for (const glm::uvec3& t : mesh.triangles) {
            const unsigned a = middle(t.x, t.y), b = middle(t.y, t.z), c = middle(t.z, t.x);
            for (const glm::uvec3& part : {glm::uvec3(t.x, a, c), glm::uvec3(a, t.y, b),
                                           glm::uvec3(c, b, t.z), glm::uvec3(a, b, c)})
                finer.push_back(part);
        }
        mesh.triangles = std::move(finer);
    }
    return mesh;
}

Mesh rectangle(const glm::dvec3& c, const glm::dvec3& a, const glm::dvec3& b) {
    Mesh mesh;
    mesh.positions = {c, c + a, c + a + b, c + b};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

Mesh triangle_soup(Random& random, unsigned count) {
    Mesh mesh;
    while (mesh.triangles.size() < count) {
        const glm::dvec3 c = random_point(random);
        const double size = random.log_uniform(1e-3, 1);
        glm::dvec3 a = c + size * random_point(random), b = c + size * random_point(random);
        switch (random.below(10)) {
            case 0:
                b = a + 1e-6 * random_point(random);
                break;  // a sliver
            case 1:
                b = glm::mix(c, a, random.uniform(-1, 2));
                break;  // no area, but for rounding
            case 2:
                b = c;
                break;  // no area
            case 3:
                a.x = b.x = c.x;
                break;  // in a plane x = constant
            case 4:
                a.z = b.z = c.z;
                break;
            case 5:
                a = random_point(random), b = random_point(random);
                break;  // huge
            default:
                break;
        }
        const auto first = static_cast<unsigned>(mesh.positions.size());
        for (const glm::dvec3& p : {c, a, b}) mesh.positions.push_back(glm::clamp(p, -1.0, 1.0));
        mesh.triangles.push_back({first, first + 1, first + 2});
        const std::uint32_t again = random.below(8);
        if (again == 0) mesh.triangles.push_back(mesh.triangles.back());
        if (again > 4) {  // once more, a little aside
            const glm::dvec3 aside = random.log_uniform(1e-7, 1e-3) * random_direction(random);
            for (unsigned k = 0; k < 3; ++k)
                mesh.positions.push_back(glm::clamp(mesh.positions[first + k] + aside, -1.0, 1.0));
            mesh.triangles.push_back({first + 3, first + 4, first + 5});
        }
    }
    return mesh;
}

void transform(Mesh& mesh, const glm::dmat4& matrix) {
    for (glm::dvec3& p : mesh.positions) p = glm::dvec3(matrix * glm::dvec4(p, 1));
}

glm::dvec3 random_direction(Random& random) {
    for (;;) {
        const glm::dvec3 v = random_point(random);
        const double squared = glm::dot(v, v);
        if (squared <= 1 && squared > 1e-6) return v / std::sqrt(squared);
    }
}

glm::dvec3 random_point(Random& random) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    return {x, y, random.uniform(-1, 1)};
}

}  // namespace lobe::test
