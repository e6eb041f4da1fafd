// SPDX-License-Identifier: Apache-2.0
// Which way a shape's normal points is pbrt's rule: a triangle mesh with normals N shows its side
// of N (decided here by the majority of its triangles; in version 4 ReverseOrientation turns N
// round first); without N, and on spheres, the normal is turned if ReverseOrientation or the
// transform's handedness, but not both, ask for it.
#include "scene/shapes.h"

#include <cmath>

#include "base/files.h"
#include "base/sha256.h"
#include "scene/mesh.h"
#include "scene/ply.h"
#include "scene/transform.h"

namespace lobe {

namespace {

Mesh read_ply_mesh(Parameters& p, const ReadContext& context, Sha256& files) {
    const Parameter* given = p.find({"filename"});
    const std::string name = p.text({"filename"}, "");
    if (!given) fail(p.place(), p.title() + " lacks its parameter \"filename\"");
    const std::string path = resolve_path(context, name, given->values_place);
    const std::string bytes = read_file(path, ExitCode::scene);
    files.add(bytes);
    p.refuse({"displacement"});
    p.ignore({"edgelength"});
    return parse_ply(path, bytes);
}

Sphere read_sphere(Parameters& p, const glm::dmat4& to_world) {
    const double radius = p.number({"radius"}, 1);
    p.check_range(radius, std::numeric_limits<double>::min(),
                  std::numeric_limits<double>::infinity());
    const bool whole = p.number({"zmin"}, -radius) <= -radius &&
                       p.number({"zmax"}, radius) >= radius && p.number({"phimax"}, 360) >= 360;
    if (!whole) p.refuse({"zmin", "zmax", "phimax"}, "only whole spheres are there yet");
    const auto scale = uniform_scale(to_world);
    if (!scale)
        fail(p.place(), "a sphere under a transform that stretches it is not supported yet",
             "scale x, y and z alike, or use a mesh");
    const Sphere sphere{transform_point(to_world, glm::dvec3(0)), radius * *scale};
    if (!std::isfinite(sphere.centre.x + sphere.centre.y + sphere.centre.z + sphere.radius))
        fail(p.place(), "the sphere is not finite in world space");
    return sphere;
}

// What pbrt lets a shape line say about materials and transparency.
void refuse_material_parameters(Parameters& p) {
    for (const char* name : {"alpha", "shadowalpha"}) {
        const Parameter* given = p.find({name});
        if (given && (given->type == ParameterType::texture || p.number_of(*given) != 1))
            p.refuse({name}, "shapes without holes only");
    }
    for (const char* name :
         {"Kd", "Ks", "Kr", "Kt", "sigma", "roughness", "uroughness", "vroughness",
          "remaproughness", "eta", "k", "index", "opacity", "amount", "bumpmap"})
        p.refuse({name}, "give a shape's material parameters on its Material line");
}

void finish_mesh(Mesh& mesh, Shape& shape, const glm::dmat4& to_world, bool reverse,
                 const Parameters& p, const ReadContext& context) {
    if (!transform_mesh(mesh, to_world))
        fail(p.place(), p.title() + " has vertices that are not finite in world space");
    if (const std::size_t mended = mend_normals(mesh))
        context.warn(p.place(), std::to_string(mended) + " normals of no length are replaced");
    if (const std::size_t flat = count_degenerate(mesh))
        context.warn(p.place(), std::to_string(flat) + " of " +
                                    std::to_string(mesh.triangles.size()) +
                                    " triangles have no area");
    if (mesh.normals.empty()) {
        shape.flipped = reverse != swaps_handedness(to_world);
        return;
    }
    if (reverse && context.v4())
        for (glm::vec3& n : mesh.normals) n = -n;
    shape.flipped = unify_winding(mesh);
}

}  // namespace

Shape read_shape(const Statement& statement, const glm::dmat4& object_to_world,
                 bool reverse_orientation, const ReadContext& context, Sha256& files) {
    const Word& kind = statement.strings[0];
    Parameters p(statement, context);
    Shape shape;
    shape.where = to_string(statement.place);
    Mesh mesh;
    if (kind.text == "sphere") {
        shape.geometry = read_sphere(p, object_to_world);
        shape.flipped = reverse_orientation != swaps_handedness(object_to_world);
    } else if (kind.text == "trianglemesh") {
        mesh = read_triangle_mesh(p);
    } else if (kind.text == "loopsubdiv") {
        mesh = read_loop_mesh(p);
    } else if (kind.text == "plymesh") {
        mesh = read_ply_mesh(p, context, files);
    } else {
        fail_class(kind.place, "Shape", kind.text,
                   {"loopsubdiv", "plymesh", "sphere", "trianglemesh"},
                   {"bilinearmesh", "cone", "curve", "cylinder", "disk", "heightfield",
                    "heightfield2", "hyperboloid", "nurbs", "paraboloid"});
    }
    refuse_material_parameters(p);
    p.finish();
    if (kind.text != "sphere") {
        finish_mesh(mesh, shape, object_to_world, reverse_orientation, p, context);
        shape.geometry = std::move(mesh);
    }
    return shape;
}

}  // namespace lobe
