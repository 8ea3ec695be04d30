#pragma once

#include "raylab/scene/read_scene.h"

namespace raylab {

/// Mirrors and glass over a checkered floor, by two lights.
inline Scene glass_scene() {
    return read_scene_text(R"(
raylab = 1
image = { width = 64, height = 48 }
camera = { type = "perspective", position = [0, 1.5, 6], target = [0, 0.9, 0], up = [0, 1, 0], fov_y = 40 }
background = { color = [0.35, 0.5, 0.75], ambient = [0.2, 0.2, 0.2] }
[material.glass]
diffuse = [0.05, 0.05, 0.05]
specular = [0.6, 0.6, 0.6]
shininess = 80
kr = 0.2
kt = 0.75
ior = 1.5
[material.mirror]
diffuse = [0.3, 0.1, 0.1]
kr = 0.6
[material.floor]
ambient = [0.5, 0.5, 0.5]
diffuse = { pattern = "checker", a = [0.9, 0.85, 0.7], b = [0.3, 0.05, 0.05], size = 0.5 }
[[light]]
type = "point"
position = [3, 6, 4]
[[light]]
type = "point"
position = [-4, 5, 1]
color = [0.5, 0.5, 0.5]
[[shape]]
type = "sphere"
center = [0, 1, 0]
radius = 1
material = "glass"
[[shape]]
type = "sphere"
center = [-1.6, 0.6, 1.2]
radius = 0.6
material = "mirror"
[[shape]]
type = "sphere"
center = [0.2, 1, 0]
radius = 0.4
material = "glass"
[[shape]]
type = "triangle"
vertices = [[1.2, 0, 0.5], [2.4, 0, 0], [1.8, 1.6, 0.2]]
material = "mirror"
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
)",
                           "glass.toml");
}

}  // namespace raylab
