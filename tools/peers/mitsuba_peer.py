# SPDX-License-Identifier: Apache-2.0
"""Renders one request with Mitsuba 3: mitsuba_peer.py REQUEST.json; writes raw floats and a result.

Material: blendbsdf of `diffuse` and `roughconductor` (GGX, reflecting all), weighted by albedo.
"""
import json
import os
import sys
import time

import numpy

sys.dont_write_bytecode = True
import meshes

LANES = 1 << 24  # samples a pass; a wavefront renderer's memory grows with them


def color(rgb):
    return {"type": "rgb", "value": [float(x) for x in rgb]}


def bsdf(m):
    weight = meshes.facet_weight(m["kd"], m["ks"])
    diffuse = {"type": "diffuse", "reflectance": color(x / (1 - weight) for x in m["kd"])}
    if weight:
        facets = {"type": "roughconductor", "material": "none", "distribution": "ggx",
                  "alpha": (2 / (m["n"] + 2)) ** 0.5,
                  "specular_reflectance": color(x / weight for x in m["ks"])}
        diffuse = {"type": "blendbsdf", "weight": weight, "first": diffuse, "second": facets}
    return {"type": "twosided", "both": diffuse}


def world(mi, scene, request):
    camera, size = scene["camera"], request["size"]
    view = mi.ScalarTransform4f().look_at(camera["eye"], camera["target"], camera["up"])
    entries = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": scene["depth"] + 1, "rr_depth": 3},
        "sensor": {
            "type": "perspective", "fov": camera["fov"], "fov_axis": "smaller", "to_world": view,
            "sampler": {"type": "multijitter", "sample_count": request["spp"]},
            "film": {"type": "hdrfilm", "width": size, "height": size, "pixel_format": "rgb",
                     "component_format": "float32", "rfilter": {"type": "box"}}}}
    for i, s in enumerate(scene["shapes"]):
        if "sphere" in s:
            shape = {"type": "sphere", **s["sphere"]}
        else:
            shape = {"type": "ply", "filename": s["mesh"], "face_normals": not s["smooth"]}
        shape["bsdf"] = bsdf(s["material"])
        if s["emission"]:
            shape["emitter"] = {"type": "area", "radiance": color(s["emission"])}
        entries[f"shape{i}"] = shape
    return mi.load_dict(entries)


def main():
    with open(sys.argv[1], encoding="utf-8") as source:
        request = json.load(source)
    with open(request["scene"], encoding="utf-8") as source:
        scene = json.load(source)
    import drjit
    import mitsuba as mi
    mi.set_variant(request["engine"])
    mi.set_log_level(mi.LogLevel.Error)
    drjit.set_thread_count(request["threads"])
    loaded = world(mi, scene, request)
    size, spp = request["size"], request["spp"]
    part = max(1, LANES // size ** 2) if "llvm" in request["engine"] else spp
    start, done, picture = time.monotonic(), 0, 0
    while done < spp:
        now = min(part, spp - done)
        seed = request["seed"] * 1000 + done // part
        picture = picture + now * numpy.array(mi.render(loaded, seed=seed, spp=now))
        done += now
    seconds = time.monotonic() - start
    picture[:, ::-1].astype("<f4").tofile(request["output"])  # pbrt's camera is left-handed
    with open(request["result"], "w", encoding="utf-8") as out:
        json.dump({"render_s": seconds, "spp": spp, "scale": 1 / spp, "version": mi.__version__},
                  out)
    sys.stdout.flush()
    os._exit(0)  # some releases crash while they unload


main()
