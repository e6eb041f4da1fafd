#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads the part of pbrt that the benchmark's scenes use, for renderers that do not read pbrt.

    reader.py SCENE.pbrt FOLDER      writes FOLDER/scene.json and a binary PLY for every mesh

A directive outside that part is an error: a scene half understood would be another scene.
Materials are {kd, ks, n}: albedos of a diffuse part and of a glossy lobe of Phong exponent n.
"""
import json
import math
import os
import re
import sys

sys.dont_write_bytecode = True
import meshes

TOKEN = re.compile(r'#[^\n]*|"([^"]*)"|([\[\]])|([^\s\[\]"#]+)')
DIFFUSE = {"matte": "Kd", "diffuse": "reflectance"}
GLOSSY = {"rational", "phong", "modifiedphong"}
IGNORED = {"Sampler", "PixelFilter"}  # each renderer gets its own from the benchmark


class Unreadable(Exception):
    pass


def tokens(text):
    for match in TOKEN.finditer(text):
        string, bracket, word = match.groups()
        if string is not None:
            yield "string", string
        elif bracket or word:
            yield "bracket" if bracket else "word", bracket or word


def directives(path):
    """(name, strings and numbers before the parameters, parameters) of the file and its Includes."""
    with open(path, encoding="utf-8") as source:
        stream = list(tokens(source.read()))
    i = 0
    while i < len(stream):
        name, plain, parameters = stream[i][1], [], {}
        i += 1
        while i < len(stream):
            kind, text = stream[i]
            if kind == "word" and re.match(r"[A-Z]", text):
                break
            i += 1
            if kind == "bracket":
                continue
            if kind == "string" and len(text.split()) == 2:
                values, bracketed = [], stream[i][1] == "["
                i += bracketed
                while stream[i][1] != "]" if bracketed else not values:
                    values.append(stream[i][1])
                    i += 1
                i += bracketed
                parameters[text.split()[1]] = values
            else:
                plain.append(text)
        if name == "Include":
            yield from directives(os.path.join(os.path.dirname(path), plain[0]))
        else:
            yield name, plain, parameters


def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


IDENTITY = [[float(i == j) for j in range(4)] for i in range(4)]


def translation(x, y, z):
    return [[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]]


def scaling(x, y, z):
    return [[x, 0, 0, 0], [0, y, 0, 0], [0, 0, z, 0], [0, 0, 0, 1]]


def rotation(degrees, *axis):
    length = math.sqrt(sum(x * x for x in axis))
    u = [x / length for x in axis]
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    cross = [[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]]
    m = [[(1 - c) * u[i] * u[j] + c * (i == j) + s * cross[i][j] for j in range(3)] + [0]
         for i in range(3)]
    return m + [[0, 0, 0, 1]]


def floats(values):
    return [float(x) for x in values]


def point(m, p):
    return tuple(sum(m[i][k] * p[k] for k in range(3)) + m[i][3] for i in range(3))


def triples(values, kind):
    return [tuple(map(kind, values[i:i + 3])) for i in range(0, len(values), 3)]


def material(kind, p):
    if kind in DIFFUSE:
        return {"kd": floats(p.get(DIFFUSE[kind], [0.5] * 3)), "ks": [0, 0, 0], "n": 0}
    if kind in GLOSSY and p.get("normalize") == ["true"]:
        return {"kd": floats(p["kd"]), "ks": floats(p["ks"]), "n": float(p["n"][0])}
    raise Unreadable(f'material "{kind}" is not read (matte, diffuse, or a normalized lobe)')


def shape(kind, p, transform):
    """A sphere, or points, triangles and whether normals are to be smooth."""
    if kind == "sphere":
        scale = math.sqrt(sum(transform[i][0] ** 2 for i in range(3)))
        return {"sphere": {"center": point(transform, (0, 0, 0)),
                           "radius": scale * float(p.get("radius", [1])[0])}}
    if kind not in ("trianglemesh", "loopsubdiv"):
        raise Unreadable(f'shape "{kind}" is not read (sphere, trianglemesh, loopsubdiv)')
    points, triangles = triples(p["P"], float), triples(p["indices"], int)
    if kind == "loopsubdiv":
        points, triangles = meshes.limit_surface(points, triangles, int(p.get("levels", [3])[0]))
    return {"points": [point(transform, q) for q in points], "triangles": triangles,
            "smooth": kind == "loopsubdiv"}


def read(path):
    """The scene as a dictionary; points of meshes are in world space."""
    scene = {"shapes": []}
    state = {"transform": IDENTITY, "material": material("matte", {}), "emission": None}
    stack = []
    moves = {"Translate": translation, "Scale": scaling, "Rotate": rotation}
    for name, plain, p in directives(path):
        if name in ("AttributeBegin", "TransformBegin"):
            stack.append(dict(state))
        elif name == "AttributeEnd":
            state = stack.pop()
        elif name == "TransformEnd":
            state["transform"] = stack.pop()["transform"]
        elif name in moves:
            state["transform"] = multiply(state["transform"], moves[name](*floats(plain)))
        elif name == "LookAt" and "camera" not in scene:
            v = floats(plain)
            scene["camera"] = {"eye": v[0:3], "target": v[3:6], "up": v[6:9]}
        elif name == "Camera" and plain == ["perspective"] and "camera" in scene:
            scene["camera"]["fov"] = float(p.get("fov", [90])[0])
        elif name == "Film":
            scene["resolution"] = [int(p[key][0]) for key in ("xresolution", "yresolution")]
        elif name == "Integrator" and plain == ["path"]:
            scene["depth"] = int(p.get("maxdepth", [5])[0])
        elif name == "WorldBegin":
            state["transform"] = IDENTITY
        elif name == "Material":
            state["material"] = material(plain[0], p)
        elif name == "AreaLightSource" and plain == ["diffuse"]:
            state["emission"] = floats(p["L"])
        elif name == "Shape":
            scene["shapes"].append({**shape(plain[0], p, state["transform"]),
                                    "material": state["material"], "emission": state["emission"]})
        elif name not in IGNORED | {"WorldEnd"}:
            raise Unreadable(f"{name} {' '.join(plain)} is not read".replace("  ", " "))
    missing = {"camera", "resolution", "depth"} - scene.keys()
    if missing or "fov" not in scene["camera"]:
        raise Unreadable("no " + ", ".join(sorted(missing)) if missing else "no field of view")
    return scene


def counts(scene):
    """Triangles and spheres, to be held against what lobe counts."""
    return (sum(len(s.get("triangles", ())) for s in scene["shapes"]),
            sum("sphere" in s for s in scene["shapes"]))


def write(scene, folder):
    """scene.json, and each mesh in a PLY of its own: spheres too, for renderers without them."""
    os.makedirs(folder, exist_ok=True)
    triangles, spheres = counts(scene)
    for i, s in enumerate(scene["shapes"]):
        if "sphere" in s:
            points, faces = meshes.sphere(**s["sphere"], levels=2 if s["emission"] else 4)
            smooth = True
        else:
            points, faces, smooth = s.pop("points"), s.pop("triangles"), s.pop("smooth")
        s["smooth"], s["mesh"] = smooth, os.path.join(folder, f"shape{i}.ply")
        meshes.write_ply(s["mesh"], points, faces, smooth)
    scene.update(triangles=triangles, spheres=spheres)
    with open(os.path.join(folder, "scene.json"), "w", encoding="utf-8") as out:
        json.dump(scene, out, indent=1)


def main():
    try:
        write(read(sys.argv[1]), sys.argv[2])
    except (Unreadable, OSError, KeyError, IndexError, ValueError) as fault:
        sys.exit(f"reader.py: {sys.argv[1]}: {fault!r}" if isinstance(fault, (KeyError, IndexError))
                 else f"reader.py: {sys.argv[1]}: {fault}")


if __name__ == "__main__":
    main()
