// SPDX-License-Identifier: Apache-2.0
#include "support/trace_rig.h"

namespace lobe::test {

namespace {

struct DeviceRays {
    explicit DeviceRays(const std::vector<TestRay>& rays)
        : numbers(test_device(), pack_numbers(rays)), names(test_device(), pack_names(rays)) {}

    static std::vector<float> pack_numbers(const std::vector<TestRay>& rays) {
        std::vector<float> n;
        n.reserve(rays.size() * 8);
        for (const TestRay& r : rays)
            n.insert(n.end(), {r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y,
                               r.direction.z, r.reach, 0});
        return n;
    }
    static std::vector<cl_uint> pack_names(const std::vector<TestRay>& rays) {
        std::vector<cl_uint> n;
        for (const TestRay& r : rays) n.insert(n.end(), {r.from, r.target});
        return n;
    }

    Buffer<float> numbers;
    Buffer<cl_uint> names;
};

std::vector<TestHit> read_hits(const Buffer<float>& out, const Buffer<cl_uint>& primitives) {
    const std::vector<float> numbers = out.read_all();
    const std::vector<cl_uint> names = primitives.read_all();
    std::vector<TestHit> hits;
    for (std::size_t i = 0; i < names.size(); ++i)
        hits.push_back({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2], names[i]});
    return hits;
}

}  // namespace

Shape shape_of(Mesh mesh) {
    Shape shape;
    shape.geometry = std::move(mesh);
    shape.where = "test";
    return shape;
}

Shape shape_of(Sphere sphere) {
    Shape shape;
    shape.geometry = sphere;
    shape.where = "test";
    return shape;
}

Scene scene_of(std::vector<Shape> shapes) {
    Scene scene;
    scene.film.width = scene.film.height = 8;
    scene.materials.push_back({"lambert", {{{0.25f, 0.25f, 0.25f, 0}}}, "test", "test"});
    scene.shapes = std::move(shapes);
    return scene;
}

TraceRig::TraceRig(const Mesh& mesh, const std::vector<Sphere>& spheres) {
    packed_.surfaces.push_back({0, LOBE_NONE, 0, 0});
    for (const glm::dvec3& p : mesh.positions)
        packed_.vertices.push_back({float(p.x), float(p.y), float(p.z), 0, 0, 0, 0, 0});
    for (const glm::uvec3& t : mesh.triangles) packed_.triangles.push_back({t.x, t.y, t.z, 0});
    for (const Sphere& s : spheres)
        packed_.spheres.push_back(
            {float(s.centre.x), float(s.centre.y), float(s.centre.z), float(s.radius), 0, 0, 0, 0});
    packed_.bvh = build_bvh(packed_.triangles, packed_.vertices, packed_.spheres);
    upload();
}

TraceRig::TraceRig(const Scene& scene) : packed_(pack_scene(scene)) { upload(); }

void TraceRig::upload() {
    nodes_.emplace_back(test_device(), packed_.bvh.nodes);
    triangle_leaves_.emplace_back(test_device(), packed_.bvh.triangle_leaves);
    sphere_leaves_.emplace_back(test_device(), packed_.bvh.sphere_leaves);
}

std::vector<TestHit> TraceRig::nearest(const Program& program, const std::vector<TestRay>& rays,
                                       Traversal traversal) const {
    const DeviceRays in(rays);
    Buffer<float> out(test_device(), 3 * rays.size());
    Buffer<cl_uint> primitives(test_device(), rays.size());
    const bool together = traversal == Traversal::together;
    run_probe(program, together ? "geom_nearest_together" : "geom_nearest",
              together ? rays.size() / LOBE_WIDTH : rays.size(), nodes_[0], triangle_leaves_[0],
              sphere_leaves_[0], in.numbers, in.names, out, primitives);
    return read_hits(out, primitives);
}

std::vector<TestHit> TraceRig::linear(const Program& program,
                                      const std::vector<TestRay>& rays) const {
    const DeviceRays in(rays);
    Buffer<float> out(test_device(), 3 * rays.size());
    Buffer<cl_uint> primitives(test_device(), rays.size());
    run_probe(program, "geom_linear", rays.size(), triangle_leaves_[0],
              static_cast<cl_uint>(packed_.bvh.triangle_leaves.size()), sphere_leaves_[0],
              static_cast<cl_uint>(packed_.bvh.sphere_leaves.size()), in.numbers, in.names, out,
              primitives);
    return read_hits(out, primitives);
}

std::vector<std::uint32_t> TraceRig::occluded(const Program& program,
                                              const std::vector<TestRay>& rays) const {
    const DeviceRays in(rays);
    Buffer<cl_uint> out(test_device(), rays.size());
    run_probe(program, "geom_occluded", rays.size(), nodes_[0], triangle_leaves_[0],
              sphere_leaves_[0], in.numbers, in.names, out);
    return out.read_all();
}

std::vector<LeavingRay> TraceRig::leave(const Program& program, const std::vector<TestRay>& rays,
                                        const std::vector<glm::vec3>& ways) const {
    const DeviceRays in(rays);
    std::vector<float> way_numbers;
    for (const glm::vec3& w : ways) way_numbers.insert(way_numbers.end(), {w.x, w.y, w.z});
    Buffer<float> out(test_device(), 8 * rays.size());
    Buffer<cl_uint> from(test_device(), 2 * rays.size());
    run_probe(program, "geom_leave", rays.size(), nodes_[0], triangle_leaves_[0], sphere_leaves_[0],
              Buffer<LobeTriangle>(test_device(), packed_.triangles),
              Buffer<LobeVertex>(test_device(), packed_.vertices),
              Buffer<LobeSphere>(test_device(), packed_.spheres),
              Buffer<LobeSurface>(test_device(), packed_.surfaces),
              static_cast<cl_uint>(packed_.triangles.size()), in.numbers, in.names,
              Buffer<float>(test_device(), way_numbers), out, from);
    const std::vector<float> n = out.read_all();
    const std::vector<cl_uint> names = from.read_all();
    std::vector<LeavingRay> leaving;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const float* r = &n[8 * i];
        leaving.push_back({{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, r[6], names[2 * i]}, r[7]});
    }
    return leaving;
}

Program build_trace_probe(const std::string& header, Texts texts) {
    texts.emplace("lobe_scene.h", header + scene_header(all_features(), {}));
    return build_probe("probe/geom.cl", texts);
}

}  // namespace lobe::test
