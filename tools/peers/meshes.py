# SPDX-License-Identifier: Apache-2.0
"""Meshes that every renderer takes: subdivided surfaces, balls made of triangles, PLY files."""
import math
import os
import struct
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../scenes"))
from loop_surface import cross, limit_surface, subtract  # noqa: F401, the first for reader.py


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v) if length > 0 else (0.0, 0.0, 1.0)


def refine(points, triangles):
    """Each triangle in four, new vertices pushed out to the unit sphere."""
    points, middle, finer = list(points), {}, []

    def between(a, b):
        key = (min(a, b), max(a, b))
        if key not in middle:
            middle[key] = len(points)
            points.append(unit(tuple(x + y for x, y in zip(points[a], points[b]))))
        return middle[key]

    for a, b, c in triangles:
        ab, bc, ca = between(a, b), between(b, c), between(c, a)
        finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return points, finer


def area(points, triangles):
    normals = (cross(subtract(points[b], points[a]), subtract(points[c], points[a]))
               for a, b, c in triangles)
    return sum(0.5 * math.sqrt(sum(x * x for x in n)) for n in normals)


def sphere(center, radius, levels):
    """A ball of 8 * 4^levels triangles with the sphere's area: a lamp then keeps its power, and,
    the body being convex, its mean irradiance from all sides."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    triangles = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4),
                 (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(levels):
        points, triangles = refine(points, triangles)
    scale = radius * math.sqrt(4 * math.pi / area(points, triangles))
    return [tuple(c + scale * x for c, x in zip(center, p)) for p in points], triangles


def facet_weight(kd, ks):
    """Weight of the glossy part where a renderer mixes instead of adding: as the albedos, so far as
    kd / (1 - weight) and ks / weight stay below one, which a mixing renderer needs."""
    if max(ks) == 0:
        return 0
    return min(max(sum(ks) / (sum(kd) + sum(ks)), max(ks)), 1 - max(kd))


def vertex_normals(points, triangles):
    """Mean of the normals around each vertex, weighted by area."""
    sums = [(0.0, 0.0, 0.0)] * len(points)
    for t in triangles:
        a, b, c = (points[i] for i in t)
        n = cross(subtract(b, a), subtract(c, a))
        for i in t:
            sums[i] = tuple(x + y for x, y in zip(sums[i], n))
    return [unit(n) for n in sums]


def write_ply(path, points, triangles, smooth):
    names = ["x", "y", "z"] + (["nx", "ny", "nz"] if smooth else [])
    rows = [p + n for p, n in zip(points, vertex_normals(points, triangles))] if smooth else points
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}",
            *(f"property float {name}" for name in names), f"element face {len(triangles)}",
            "property list uchar int vertex_indices", "end_header"]
    with open(path, "wb") as out:
        out.write(("\n".join(head) + "\n").encode("ascii"))
        out.write(b"".join(struct.pack(f"<{len(names)}f", *row) for row in rows))
        out.write(b"".join(struct.pack("<B3i", 3, *t) for t in triangles))


def read_ply(path):
    """Points and triangles of a file that write_ply wrote."""
    with open(path, "rb") as source:
        head, data = source.read().split(b"end_header\n", 1)
    lines = head.decode("ascii").split("\n")
    vertices, faces = (int(line.split()[2]) for line in lines if line.startswith("element"))
    width = sum(line.startswith("property float") for line in lines)
    rows = struct.iter_unpack(f"<{width}f", data[:4 * width * vertices])
    rest = data[4 * width * vertices:]
    return [row[:3] for row in rows], [t[1:] for t in struct.iter_unpack("<B3i", rest[:13 * faces])]
