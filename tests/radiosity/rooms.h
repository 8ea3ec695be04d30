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

/// Adds a box of half the room's width that stands on the floor's middle and has no bottom.
inline void add_box_without_bottom(Scene& scene) {
    const Vec3f x{0.5f, 0, 0}, y{0, 0.25f, 0}, z{0, 0, 0.5f}, corner{0.25f, 0, 0.25f};
    for (const Polygon& side :
         {float_rectangle(corner + y, z, x), float_rectangle(corner, y, x), float_rectangle(corner, z, y),
          float_rectangle(corner + x, y, z), float_rectangle(corner + z, x, y)})
        scene.objects.push_back({.shape = side, .front = 0, .back = 0, .sides = Sides::front});
}

}  // namespace raylab
