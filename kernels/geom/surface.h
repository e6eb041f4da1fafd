// SPDX-License-Identifier: Apache-2.0
// The point where a ray meets a shape, with a bound on where rounding may have put it.
//
// Points come from barycentric weights or from the sphere's centre, never from origin + t d, and
// rays leave from a point moved along the normal by the error bound: no epsilon depends on the
// scene's scale (Pharr, Jakob, Humphreys, "Physically Based Rendering", section 3.9).
#ifndef LOBE_GEOM_SURFACE_H
#define LOBE_GEOM_SURFACE_H

#include "geom/ray.h"

typedef struct {
    global const LobeTriangle* triangles;
    global const LobeVertex* vertices;
    global const LobeSphere* spheres;
    global const LobeSurface* surfaces;
    uint triangle_count;
} Shapes;

typedef struct {
    real3 position;
    real3 error;      // each coordinate of the true point lies within this of `position`
    real3 geometric;  // unit normal of the shape, on the side that its light leaves
    real3 shading;    // unit normal for reflection
    uint material, light, primitive;
} Surface;

real3 vertex_position(global const LobeVertex* v) { return (real3)(v->px, v->py, v->pz); }
real3 vertex_normal(global const LobeVertex* v) { return (real3)(v->nx, v->ny, v->nz); }

Surface name_surface(const Shapes* shapes, uint surface, uint primitive) {
    Surface s;
    global const LobeSurface* shared = &shapes->surfaces[surface];
    s.material = shared->material;
    s.primitive = primitive;
    s.light = shared->first_light == LOBE_NONE
                  ? LOBE_NONE
                  : shared->first_light + (primitive - shared->first_primitive);
    return s;
}

Surface triangle_surface(const Shapes* shapes, const Hit* hit) {
    LobeTriangle triangle = shapes->triangles[hit->primitive];
    Surface s = name_surface(shapes, triangle.surface, hit->primitive);
    uint flags = shapes->surfaces[triangle.surface].flags;
    global const LobeVertex* v0 = &shapes->vertices[triangle.v0];
    global const LobeVertex* v1 = &shapes->vertices[triangle.v1];
    global const LobeVertex* v2 = &shapes->vertices[triangle.v2];
    real b0 = 1 - hit->b1 - hit->b2;
    real3 p0 = vertex_position(v0), p1 = vertex_position(v1), p2 = vertex_position(v2);
    real3 normal = normalize(cross(p1 - p0, p2 - p0));
    s.geometric = flags & LOBE_SURFACE_FLIPPED ? -normal : normal;
    s.position = b0 * p0 + hit->b1 * p1 + hit->b2 * p2;
    // Seven roundings in weights, products and sums, and two more for the move along the normal.
    // Each axis has its own bound, so that a wide floor does not lift rays above what stands on it;
    // but it is at least that of the point's largest coordinate: a triangle in the plane z = 0 has
    // an exact z, while the test of another one in that plane, with a slanting ray, rounds as x and
    // y do.
    real3 size = fabs(b0 * p0) + fabs(hit->b1 * p1) + fabs(hit->b2 * p2);
    size = max(size, (real3)(largest_component(fabs(s.position))));
    s.error = 9 * REAL_EPSILON * size;
    s.shading = s.geometric;
    if (flags & LOBE_SURFACE_NORMALS) {
        real3 n =
            b0 * vertex_normal(v0) + hit->b1 * vertex_normal(v1) + hit->b2 * vertex_normal(v2);
        real length_squared = dot(n, n);
        if (length_squared > R(1e-12)) s.shading = n / sqrt(length_squared);
    }
    return s;
}

Surface sphere_surface(const Shapes* shapes, const Ray* ray, const Hit* hit) {
    LobeSphere sphere = shapes->spheres[hit->primitive - shapes->triangle_count];
    Surface s = name_surface(shapes, sphere.surface, hit->primitive);
    uint flags = shapes->surfaces[sphere.surface].flags;
    real3 centre = (real3)(sphere.x, sphere.y, sphere.z);
    real3 outwards = normalize(ray->origin + hit->distance * ray->direction - centre);
    s.position = centre + sphere.radius * outwards;
    s.error = REAL_EPSILON * (6 * fabs(sphere.radius * outwards) + 3 * fabs(s.position));
    s.geometric = flags & LOBE_SURFACE_FLIPPED ? -outwards : outwards;
    s.shading = s.geometric;
    return s;
}

int is_sphere(const Shapes* shapes, uint primitive) {
    if (!LOBE_HAS_SPHERES) return 0;
    if (!LOBE_HAS_TRIANGLES) return 1;
    return primitive >= shapes->triangle_count;
}

// What `ray` met; `hit` names a primitive.
Surface surface_at(const Shapes* shapes, const Ray* ray, const Hit* hit) {
    if (is_sphere(shapes, hit->primitive)) return sphere_surface(shapes, ray, hit);
    return triangle_surface(shapes, hit);
}

// A ray that leaves the surface along `direction`, on that side of it for certain.
Ray leave_surface(const Surface* s, real3 direction) {
    real distance = dot(fabs(s->geometric), s->error);
    real side = dot(direction, s->geometric) < 0 ? -distance : distance;
    return make_ray(s->position + side * s->geometric, direction, s->primitive);
}

#endif
