#pragma once

#include "raylab/scene/scene.h"

#include <array>

// Rooms whose radiosities are known.

namespace raylab {

inline Polygon float_rectangle(Vec3f corner, Vec3f u, Vec3f v) {
    return {{corner, corner + u, corner + u + v, corner + v}};
}

/// The six faces of the unit cube, seen from inside, each with a material of its own: floor, ceiling, then the walls.
inline Scene cube_room(double reflectance) {
    Scene scene;
    scene.source = "cube.toml";
    const std::array<Polygon, 6> faces{
        float_rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}), float_rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}),
        float_rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), float_rectangle({1, 0, 0}, {0, 0, 1}, {0, 1, 0}),
        float_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), float_rectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0})};
    for (const Polygon& face : faces) {
        scene.materials.push_back({.diffuse = Color(reflectance)});
        const std::size_t material = scene.materials.size() - 1;
        scene.objects.push_back({.shape = face, .front = material, .back = material, .sides = Sides::front});
    }
    return scene;
}

}  // namespace raylab
