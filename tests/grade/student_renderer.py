#!/usr/bin/env python3
"""student_renderer.py SCENE.toml OUT.png: a whole renderer, for chapter 01's scenes.

It knows spheres and convex polygons in light that comes from everywhere, and shares no line with the lab.
"""
import struct
import sys
import tomllib
import zlib


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a, b, t=1.0):
    return [x + t * y for x, y in zip(a, b)]


def unit(a):
    return [x / dot(a, a) ** 0.5 for x in a]


def sphere_hit(shape, origin, direction):
    f = plus(origin, shape["center"], -1)
    b, c, a = dot(f, direction), dot(f, f) - shape["radius"] ** 2, dot(direction, direction)
    if b * b < a * c:
        return None
    return (-b - (b * b - a * c) ** 0.5) / a


def polygon_hit(shape, origin, direction):
    v = shape["vertices"]
    normal = cross(plus(v[1], v[0], -1), plus(v[2], v[0], -1))
    t = dot(plus(v[0], origin, -1), normal) / dot(direction, normal)
    point = plus(origin, direction, t)
    sides = [dot(cross(plus(b, a, -1), plus(point, a, -1)), normal) for a, b in zip(v, v[1:] + v[:1])]
    return t if min(sides) >= 0 else None


def rays(scene):
    camera, width, height = scene["camera"], scene["image"]["width"], scene["image"]["height"]
    forward = unit(plus(camera["target"], camera["position"], -1))
    right = unit(cross(forward, camera.get("up", [0, 1, 0])))
    up = cross(right, forward)
    orthographic = camera.get("type") == "orthographic"
    from math import radians, tan
    half = camera["height"] / 2 if orthographic else tan(radians(camera["fov_y"]) / 2)
    for y in range(height):
        for x in range(width):
            u = (2 * (x + 0.5) / width - 1) * half * width / height
            v = (1 - 2 * (y + 0.5) / height) * half
            beside = plus([u * r for r in right], up, v)
            if orthographic:
                yield plus(camera["position"], beside), forward
            else:
                yield camera["position"], plus(forward, beside)


def color(scene, origin, direction):
    hits = []
    for shape in scene["shape"]:
        t = (sphere_hit if shape["type"] == "sphere" else polygon_hit)(shape, origin, direction)
        if t is not None and t > 0:
            hits.append((t, shape["material"]))
    background = scene["background"]
    if not hits:
        return background["color"]
    material = scene["material"][min(hits)[1]]
    return [a * m for a, m in zip(background["ambient"], material["ambient"])]


def srgb(value):
    return round(255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055))


scene = tomllib.load(open(sys.argv[1], "rb"))
width, height = scene["image"]["width"], scene["image"]["height"]
pixels = [bytes(srgb(c) for c in color(scene, *ray)) for ray in rays(scene)]
lines = b"".join(b"\0" + b"".join(pixels[y * width:(y + 1) * width]) for y in range(height))


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


with open(sys.argv[2], "wb") as file:
    file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
               chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))
