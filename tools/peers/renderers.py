# SPDX-License-Identifier: Apache-2.0
"""The renderers side by side: how each is found, called, and read.

To add one: a script that renders a request (see request()) and a row in RENDERERS. Renderers of one
family make the same picture and share a reference.
"""
import json
import os
import re
import shutil
import subprocess
from dataclasses import dataclass

import pictures

HERE = os.path.dirname(os.path.abspath(__file__))


@dataclass(frozen=True)
class Renderer:
    name: str
    family: str
    title: str
    script: str  # rendering a request; none for lobe
    engine: str
    install: str  # what to type where it is missing
    glossy: str  # what stands for the glossy material, and in what it differs
    compiles: bool = False  # keeps compiled kernels, so that its first run takes longer


MITSUBA = ("roughconductor (GGX) blended with diffuse", "pip install mitsuba numpy")
LUXCORE = ("metal2 (Schlick's facets, Fresnel factor) mixed with matte; a shining ball is a sphere "
           "light, not seen in reflections",
           "pip install pyluxcore")
RENDERERS = [
    Renderer("lobe", "lobe", "lobe", "", "", "tools/build lobe",
             "GGX facets added to a diffuse part (tools/peers/glossy.cl)", True),
    Renderer("mitsuba-llvm", "Mitsuba", "Mitsuba 3, llvm_ad_rgb", "mitsuba_peer.py", "llvm_ad_rgb",
             MITSUBA[1], MITSUBA[0], True),
    Renderer("mitsuba-scalar", "Mitsuba", "Mitsuba 3, scalar_rgb", "mitsuba_peer.py", "scalar_rgb",
             MITSUBA[1], MITSUBA[0]),
    Renderer("luxcore", "LuxCore", "LuxCore, PATHCPU", "luxcore_peer.py", "PATHCPU",
             LUXCORE[1], LUXCORE[0]),
    Renderer("luxcore-opencl", "LuxCore", "LuxCore, PATHOCL", "luxcore_peer.py", "PATHOCL",
             LUXCORE[1], LUXCORE[0], True),
    Renderer("cycles", "Cycles", "Cycles, CPU", "cycles_peer.py", "CPU",
             "apt-get install blender",
             "glossy GGX (separable shadowing) added to diffuse; a shining ball is a point lamp"),
]
# PATHOCL may compile for many minutes on a CPU, so it runs when asked for.
STANDARD = [r.name for r in RENDERERS if r.name != "luxcore-opencl"]


def version(renderer, options):
    """The version, or None if the renderer is not installed."""
    module = {"Mitsuba": "mitsuba", "LuxCore": "pyluxcore"}.get(renderer.family)
    if module:
        command = [options.python, "-c", "import importlib.metadata as m, sys; "
                   f"print(m.version('{module}'))"]
    else:
        command = [options.lobe if renderer.name == "lobe" else options.blender, "--version"]
    try:
        answer = subprocess.run(command, capture_output=True, text=True, timeout=120)
    except OSError:
        return None
    return answer.stdout.split("\n")[0].strip() if answer.returncode == 0 else None


def environment(renderer, options, caches):
    """Kernel caches in a folder of our own, so that cold is cold and warm is warm."""
    added = {"HOME": caches, "POCL_CACHE_DIR": os.path.join(caches, "pocl"),
             "LOBE_CACHE_DIR": os.path.join(caches, "lobe"),
             "POCL_MAX_PTHREAD_COUNT": str(options.threads)}
    if renderer.family == "LuxCore":  # its allocator must be everybody's, or OpenCL's frees crash
        find = "import glob, importlib.util as u; print(*glob.glob(u.find_spec('pyluxcore').origin" \
               ".rsplit('/', 2)[0] + '/pyluxcore.libs/libtbbmalloc_proxy*'))"
        found = subprocess.run([options.python, "-c", find], capture_output=True, text=True)
        added["LD_PRELOAD"] = found.stdout.strip()
    for folder in (caches, added["POCL_CACHE_DIR"], added["LOBE_CACHE_DIR"]):
        os.makedirs(folder, exist_ok=True)
    return {**os.environ, **added}


def forget_kernels(caches):
    shutil.rmtree(caches, ignore_errors=True)


def request(renderer, scene, options, spp, seed, stem):
    """Command of one render; it leaves STEM.picture and STEM.json."""
    output, result = stem + ".picture", stem + ".json"
    if renderer.name == "lobe":
        output = stem + ".exr"
        glossy = ["--brdf", os.path.join(HERE, "glossy.cl"), "--replace", "rational=glossy"]
        return [options.lobe, "render", scene["path"], *(glossy if scene["glossy"] else []),
                "--resolution", f"{options.size}x{options.size}", "--filter", "box:0.5",
                "--spp", str(spp), "--seed", str(seed), "--quiet", "--json", result, "-o", output]
    with open(stem + ".request", "w", encoding="utf-8") as out:
        json.dump({"scene": scene["json"], "size": options.size, "spp": spp, "seed": seed,
                   "threads": options.threads, "engine": renderer.engine, "output": output,
                   "result": result}, out)
    script = os.path.join(HERE, renderer.script)
    if renderer.name == "cycles":
        return [options.blender, "-b", "--factory-startup", "--python-exit-code", "1",
                "-P", script, "--", stem + ".request"]
    return [options.python, script, stem + ".request"]


def sampling_seconds(log):
    """What Blender says that sampling took, to 0.01 s: export and hierarchy come before."""
    with open(log, encoding="utf-8", errors="replace") as source:
        clock = [60 * int(minutes) + float(seconds) for minutes, seconds in
                 re.findall(r"Time:(\d+):(\d+\.\d+) .*(?:Sample 0/|Finished)", source.read())]
    return clock[-1] - clock[0]


def read(renderer, options, stem):
    """Luminances, seconds of rendering alone, and the samples a pixel in fact taken."""
    with open(stem + ".json", encoding="utf-8") as source:
        result = json.load(source)
    if renderer.name == "lobe":
        return pictures.read_exr(stem + ".exr"), result["seconds"]["render"], result["spp"]
    if renderer.name == "cycles":  # written by Blender; pbrt's camera is left-handed
        picture, n = pictures.read_exr(stem + ".picture"), options.size
        for row in range(0, n * n, n):
            picture[row:row + n] = picture[row:row + n][::-1]
        return picture, sampling_seconds(stem + ".log"), result["spp"]
    picture = pictures.read_raw(stem + ".picture", result["scale"])
    return picture, result["render_s"], result["spp"]
