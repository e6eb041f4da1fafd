# SPDX-License-Identifier: Apache-2.0
"""Renders one request with Cycles: blender -b -P cycles_peer.py -- REQUEST.json

Material: the sum of a diffuse and a glossy (GGX, no Fresnel factor) closure. A sphere that shines
becomes a point lamp of its radius, which Cycles samples better than a mesh; other lamps are meshes
that shine on their front.
"""
import json
import math
import os
import sys

import bpy
from mathutils import Matrix, Vector

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import meshes


def shader(i, s):
    """A material of closures added up."""
    made = bpy.data.materials.new(f"material{i}")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()

    def closure(kind, rgb):
        node = nodes.new(kind)
        node.inputs["Color"].default_value = (*rgb, 1)
        return node

    m = s["material"]
    last = closure("ShaderNodeBsdfDiffuse", m["kd"]).outputs[0]
    if max(m["ks"]) > 0:
        glossy = closure("ShaderNodeBsdfGlossy", m["ks"])
        glossy.distribution = "GGX"
        glossy.inputs["Roughness"].default_value = (2 / (m["n"] + 2)) ** 0.25  # alpha's root
        last = added(nodes, links, last, glossy.outputs[0])
    if s["emission"]:
        strength = max(s["emission"])
        lamp = closure("ShaderNodeEmission", [x / strength for x in s["emission"]])
        lamp.inputs["Strength"].default_value = strength
        front = nodes.new("ShaderNodeMixShader")
        links.new(nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], front.inputs[0])
        links.new(lamp.outputs[0], front.inputs[1])
        last = added(nodes, links, last, front.outputs[0])
    links.new(last, nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return made


def added(nodes, links, a, b):
    both = nodes.new("ShaderNodeAddShader")
    links.new(a, both.inputs[0])
    links.new(b, both.inputs[1])
    return both.outputs[0]


def place_shape(i, s):
    if "sphere" in s and s["emission"]:
        strength, radius = max(s["emission"]), s["sphere"]["radius"]
        thing = bpy.data.lights.new(f"lamp{i}", "POINT")
        thing.color = [x / strength for x in s["emission"]]
        thing.shadow_soft_size = radius
        thing.energy = strength * 4 * math.pi ** 2 * radius ** 2  # watts of a Lambertian sphere
        thing.cycles.use_multiple_importance_sampling = True
        object_ = bpy.data.objects.new(f"lamp{i}", thing)
        object_.location = s["sphere"]["center"]
    else:
        points, triangles = meshes.read_ply(s["mesh"])
        mesh = bpy.data.meshes.new(f"mesh{i}")
        mesh.from_pydata(points, [], triangles)
        mesh.polygons.foreach_set("use_smooth", [s["smooth"]] * len(triangles))
        mesh.materials.append(shader(i, s))
        object_ = bpy.data.objects.new(f"object{i}", mesh)
    bpy.context.scene.collection.objects.link(object_)


def place_camera(camera):
    eye, target, up = (Vector(camera[key]) for key in ("eye", "target", "up"))
    back = (eye - target).normalized()
    right = up.cross(back).normalized()
    axes = Matrix((right, back.cross(right), back)).transposed().to_4x4()
    made = bpy.data.cameras.new("camera")
    made.angle = math.radians(camera["fov"])
    made.clip_start, made.clip_end = 1e-3, 1e6
    object_ = bpy.data.objects.new("camera", made)
    object_.matrix_world = Matrix.Translation(eye) @ axes
    bpy.context.scene.collection.objects.link(object_)
    bpy.context.scene.camera = object_


def settings(scene, request):
    render, cycles = bpy.context.scene.render, bpy.context.scene.cycles
    render.engine = "CYCLES"
    render.resolution_x = render.resolution_y = request["size"]
    render.resolution_percentage = 100
    render.threads_mode, render.threads = "FIXED", request["threads"]
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_mode = "RGB"
    render.image_settings.color_depth = "32"
    render.image_settings.exr_codec = "NONE"
    render.filepath = request["output"]
    render.use_file_extension = False
    cycles.device, cycles.samples, cycles.seed = "CPU", request["spp"], request["seed"]
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
    bounces = scene["depth"] - 1  # after the first scattering event
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = bounces
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = cycles.light_sampling_threshold = 0
    cycles.caustics_reflective = True


def main():
    with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as source:
        request = json.load(source)
    with open(request["scene"], encoding="utf-8") as source:
        scene = json.load(source)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    for i, s in enumerate(scene["shapes"]):
        place_shape(i, s)
    place_camera(scene["camera"])
    settings(scene, request)
    bpy.ops.render.render(write_still=True)
    with open(request["result"], "w", encoding="utf-8") as out:
        json.dump({"spp": request["spp"], "scale": 1, "version": bpy.app.version_string}, out)


main()
