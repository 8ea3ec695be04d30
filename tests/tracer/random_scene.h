#pragma once

#include "raylab/sampling/sequence.h"
#include "raylab/scene/scene.h"

#include <array>
#include <vector>

namespace raylab::test {

/// One to three shapes of all sorts about the origin, one or two lights and the eye in, on or outside of them.
inline Scene random_scene(std::uint64_t seed) {
    RandomSequence random(seed, 0);
    const auto below = [&](double limit) { return limit * random.next(); };
    const auto any_of = [&](const auto& choices) {
        return choices[static_cast<std::size_t>(below(double(choices.size())))];
    };
    const auto vector = [&](double size) { return random.in_cube() * size; };

    Scene scene;
    scene.image = {24, 18};
    scene.background = {any_of(std::array{Color{0, 0, 0}, Color{0.2, 0.3, 0.5}}), {0.1, 0.1, 0.1}};
    if (below(3) < 1) scene.background.zenith = Color{0.1, 0.4, 0.2};
    scene.camera.position = vector(any_of(std::array{0.6, 6.0}));
    scene.camera.target = vector(0.3) + Vec3d{0, 0, 1};
    if (below(4) < 1) scene.camera.projection = Orthographic{3};
    scene.materials = {{.diffuse = Color{0.7, 0.5, 0.2}, .specular = {0.3, 0.3, 0.3}, .shininess = 9},
                       {.diffuse = Color{0.1, 0.1, 0.1}, .kr = 0.6},
                       {.diffuse = Color{0.1, 0.1, 0.1}, .kr = 0.1, .kt = 0.8, .ior = 1.5},
                       {.diffuse = Color{0, 0, 0}, .kr = 1},
                       {.diffuse = Color{0, 0, 0}, .kt = 0.9},
                       {.diffuse = Color{0, 0, 0}, .emission = {0.2, 0, 0}}};
    for (double lights = below(2); lights > 0; --lights)
        scene.lights.push_back(
            {PointLight{vector(any_of(std::array{0.6, 5.0}))}, any_of(std::array{Color{1, 1, 1}, Color{0, 0, 0}})});
    if (below(3) < 1) scene.lights.push_back({DistantLight{vector(1)}});
    for (double shapes = below(3); shapes > 0; --shapes) {
        const Vec3f at = convert<float>(vector(0.7)), up{0, 1, 0};
        const std::vector<Shape> kinds{Sphere{at, 1},
                                       Ellipsoid{at, {1, 0.5f, 0.8f}},
                                       Cylinder{at, at + up, 0.8f, Ends::capped},
                                       Cylinder{at, at + up, 0.8f},
                                       Cone{at, at + up, 0.9f, 0, Ends::capped},
                                       Hyperboloid{at, at + up, 0.3f, 0.9f, Ends::capped},
                                       Plane{at - up, up},
                                       Disk{at, up, 1},
                                       Annulus{at, up, 0.5f, 1}};
        const auto material = [&] { return static_cast<std::size_t>(below(6)); };
        Object object{.shape = any_of(kinds),
                      .front = material(),
                      .sides = any_of(std::array{Sides::both, Sides::both, Sides::front, Sides::back})};
        object.back = below(2) < 1 ? object.front : material();
        if (below(3) < 1) object.placement.columns[0].x = -1.5f;
        scene.objects.push_back(object);
    }
    return scene;
}

}  // namespace raylab::test
