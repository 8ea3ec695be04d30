"""Draws a scene of raylab's with Blender's Cycles: blender -b --factory-startup -P cycles_picture.py -- SCENE IMAGE SAMPLES BOUNCES SEED

It knows what the scenes of this bench have: polygons, disks, spheres; diffuse and emitting materials; a distant light; a pinhole or
a lens. Anything else is refused. One thread; no denoising, no adaptive sampling, no clamping, a box filter. Prints the processor's
seconds of the rendering. Balls are meshes of 128 x 64 faces.
"""
import math
import pathlib
import resource
import sys
import tomllib

import bpy
from mathutils import Matrix, Vector


def read(path):
    """A scene with what it includes."""
    path = pathlib.Path(path)
    scene = tomllib.loads(path.read_text())
    for name in scene.pop("include", []):
        for key, value in read(path.parent / name).items():
            if isinstance(value, list):
                scene[key] = value + scene.get(key, [])
            elif isinstance(value, dict):
                scene[key] = {**value, **scene.get(key, {})}
    return scene


def material(name, keys):
    unknown = set(keys) - {"diffuse", "emission", "ambient"}
    if unknown:
        sys.exit(f"cycles_picture: material {name} has {unknown}")
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*keys.get("diffuse", (0.8, 0.8, 0.8)), 1)
    shader = diffuse.outputs[0]
    if "emission" in keys:
        emission, both = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeAddShader")
        emission.inputs["Color"].default_value = (*keys["emission"], 1)
        links.new(shader, both.inputs[0])
        links.new(emission.outputs[0], both.inputs[1])
        shader = both.outputs[0]
    links.new(shader, output.inputs["Surface"])
    return made


def turned(position, toward, up=(0, 1, 0)):
    """Where something stands whose -z looks along `toward`."""
    z = -Vector(toward).normalized()
    x = Vector(up).cross(z).normalized()
    y = z.cross(x)
    return Matrix(((x.x, y.x, z.x, position[0]), (x.y, y.y, z.y, position[1]), (x.z, y.z, z.z, position[2]), (0, 0, 0, 1)))


def add(mesh, made):
    mesh.materials.append(made)
    bpy.context.collection.objects.link(bpy.data.objects.new(mesh.name, mesh))


def shape(keys, materials):
    made = materials[keys["material"]]
    if keys["type"] == "sphere":
        bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64, radius=keys["radius"], location=keys["center"])
        bpy.ops.object.shade_smooth()
        bpy.context.object.data.materials.append(made)
        return
    if keys["type"] == "polygon":
        corners = [Vector(v) for v in keys["vertices"]]
    elif keys["type"] == "disk":
        place = turned(keys["center"], keys["normal"], (0, 0, 1))
        angles = [2 * math.pi * i / 256 for i in range(256)]
        corners = [place @ Vector((keys["radius"] * math.cos(a), -keys["radius"] * math.sin(a), 0)) for a in angles]
    else:
        sys.exit(f"cycles_picture: no {keys['type']} here")
    mesh = bpy.data.meshes.new(keys["type"])
    mesh.from_pydata(corners, [], [list(range(len(corners)))])
    add(mesh, made)


def camera(keys, scene):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(keys["fov_y"])
    toward = Vector(keys["target"]) - Vector(keys["position"])
    made = bpy.data.objects.new("camera", data)
    made.matrix_world = turned(keys["position"], toward)
    if "lens" in keys:
        data.dof.use_dof = True
        data.dof.focus_distance = keys["lens"]["focus"]
        data.dof.aperture_fstop = data.lens / 1000 / (2 * keys["lens"]["radius"])
    bpy.context.collection.objects.link(made)
    scene.camera = made


def settings(scene, image, samples, bounces, seed, output):
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = image["width"], image["height"]
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", 1
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.render.filepath = output
    scene.view_settings.view_transform = "Raw"
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", samples, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.light_sampling_threshold = 0
    cycles.max_bounces = cycles.diffuse_bounces = bounces
    scene.world = bpy.data.worlds.new("dark")
    scene.world.color = (0, 0, 0)


def main():
    name, output, samples, bounces, seed = sys.argv[sys.argv.index("--") + 1:]
    read_scene = read(name)
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    scene = bpy.context.scene
    materials = {key: material(key, keys) for key, keys in read_scene["material"].items()}
    for keys in read_scene["shape"]:
        shape(keys, materials)
    for keys in read_scene.get("light", []):
        sun = bpy.data.lights.new("sun", "SUN")
        sun.angle, sun.energy, sun.color = 0, math.pi, keys["color"]
        made = bpy.data.objects.new("sun", sun)
        made.matrix_world = turned((0, 0, 0), keys["direction"])
        bpy.context.collection.objects.link(made)
    camera(read_scene["camera"], scene)
    settings(scene, read_scene["image"], int(samples), int(bounces), int(seed), output)
    before = resource.getrusage(resource.RUSAGE_SELF)
    bpy.ops.render.render(write_still=True)
    after = resource.getrusage(resource.RUSAGE_SELF)
    print(f"rendered in {after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime} seconds")


main()
