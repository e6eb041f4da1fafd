# SPDX-License-Identifier: Apache-2.0
"""Renders one request with LuxCore: luxcore_peer.py REQUEST.json; writes raw floats and a result.

Material: `mix` of `matte` and `metal2`, whose Schlick facets are GGX with roughness^2 in alpha's
place; its Fresnel factor starts at the given colour and rises towards grazing angles. A sphere that
shines becomes a sphere light, which is noisy as a mesh: RMSE 3.4 times as large.
"""
import array
import json
import math
import os
import sys
import time

sys.dont_write_bytecode = True
import meshes

def material(name, m):
    weight = meshes.facet_weight(m["kd"], m["ks"])
    text = lambda values: " ".join(map(repr, values))
    yield f"scene.materials.{name}d.type", "matte"
    yield f"scene.materials.{name}d.kd", text(x / (1 - weight) for x in m["kd"])
    if not weight:
        return
    roughness = repr((2 / (m["n"] + 2)) ** 0.5)
    yield f"scene.textures.{name}f.type", "fresnelcolor"
    yield f"scene.textures.{name}f.kr", text(x / weight for x in m["ks"])
    yield f"scene.materials.{name}g.type", "metal2"
    yield f"scene.materials.{name}g.fresnel", name + "f"
    yield f"scene.materials.{name}g.uroughness", roughness
    yield f"scene.materials.{name}g.vroughness", roughness
    yield f"scene.materials.{name}m.type", "mix"
    yield f"scene.materials.{name}m.material1", name + "d"
    yield f"scene.materials.{name}m.material2", name + "g"
    yield f"scene.materials.{name}m.amount", repr(weight)


def scene_properties(scene, size):
    camera = scene["camera"]
    text = lambda values: " ".join(map(repr, values))
    yield "scene.camera.type", "perspective"
    yield "scene.camera.lookat.orig", text(camera["eye"])
    yield "scene.camera.lookat.target", text(camera["target"])
    yield "scene.camera.up", text(camera["up"])
    yield "scene.camera.fieldofview", repr(camera["fov"])
    pixel = 2 / size  # its pictures lie one row lower than others
    yield "scene.camera.screenwindow", f"-1 1 {-1 - pixel} {1 - pixel}"
    for i, s in enumerate(scene["shapes"]):
        if "sphere" in s and s["emission"]:
            radius = s["sphere"]["radius"]
            gain = 4 * (math.pi * radius) ** 2  # color is of the power, in units of a radiance of 1
            yield f"scene.lights.l{i}.type", "sphere"
            yield f"scene.lights.l{i}.position", text(s["sphere"]["center"])
            yield f"scene.lights.l{i}.radius", repr(radius)
            yield f"scene.lights.l{i}.color", text(s["emission"])
            yield f"scene.lights.l{i}.gain", text([gain] * 3)
            continue
        yield from material(f"m{i}", s["material"])
        top = f"m{i}m" if max(s["material"]["ks"]) else f"m{i}d"
        if s["emission"]:
            yield f"scene.materials.{top}.emission", text(s["emission"])
        yield f"scene.objects.o{i}.ply", s["mesh"]
        yield f"scene.objects.o{i}.material", top


def config_properties(scene, request):
    yield "renderengine.type", request["engine"]
    yield "renderengine.seed", str(request["seed"] + 1)
    yield "sampler.type", "SOBOL"
    yield "sampler.sobol.adaptive.strength", "0"
    yield "path.pathdepth.total", str(scene["depth"])
    for kind in ("diffuse", "glossy", "specular"):
        yield f"path.pathdepth.{kind}", str(scene["depth"])
    yield "path.russianroulette.depth", "3"
    yield "path.clamping.variance.maxvalue", "0"
    yield "native.threads.count", str(request["threads"] if "CPU" in request["engine"] else 0)
    yield "opencl.cpu.use", "1"
    yield "opencl.gpu.use", "0"
    yield "film.width", str(request["size"])
    yield "film.height", str(request["size"])
    yield "film.filter.type", "NONE"
    yield "film.opencl.enable", "0"
    yield "film.imagepipeline.0.type", "NOP"
    yield "batch.haltspp", str(request["spp"])


def main():
    with open(sys.argv[1], encoding="utf-8") as source:
        request = json.load(source)
    with open(request["scene"], encoding="utf-8") as source:
        scene = json.load(source)
    import pyluxcore
    pyluxcore.Init(lambda text: print(text, flush=True))

    def made(pairs):
        props = pyluxcore.Properties()
        props.SetFromString("".join(f"{key} = {value}\n" for key, value in pairs))
        return props

    world = pyluxcore.Scene()
    world.Parse(made(scene_properties(scene, request["size"])))
    session = pyluxcore.RenderSession(
        pyluxcore.RenderConfig(made(config_properties(scene, request)), world))
    session.Start()
    start = time.monotonic()
    while not session.HasDone():
        time.sleep(0.01)
        session.UpdateStats()
    seconds = time.monotonic() - start
    stats = session.GetStats()
    samples = stats.Get("stats.renderengine.total.samplecount").GetFloat()
    size = request["size"]
    pixels = array.array("f", bytes(12 * size * size))
    session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB_IMAGEPIPELINE, pixels)
    with open(request["output"], "wb") as out:
        for y in range(size):  # the rows go upwards, and pbrt's camera is left-handed
            row = pixels[3 * size * (size - 1 - y):3 * size * (size - y)]
            for x in range(size - 1, -1, -1):
                out.write(row[3 * x:3 * x + 3].tobytes())
    with open(request["result"], "w", encoding="utf-8") as out:
        json.dump({"render_s": seconds, "spp": samples / size ** 2, "scale": 1,
                   "version": pyluxcore.Version()}, out)
    session.Stop()
    sys.stdout.flush()
    os._exit(0)  # some releases crash while they unload


main()
