#pragma once

#include "raylab/geometry/sphere_filter.h"
#include "raylab/geometry/sphere_position.h"
#include "raylab/tracer/lighting.h"
#include "raylab/tracer/surface_point.h"

namespace raylab {

/// A sphere at rest where it was made, whose colours are the same all over, ready for many rays.
struct PlainSphere {
    PlainSphere(const Scene& scene, std::uint32_t i, const Lighting& lighting)
        : object(&scene.objects[i]),
          number(i),
          ball(std::get<Sphere>(object->shape)),
          surface(std::get<Sphere>(object->shape)),
          outside(lighting.finishes[object->front]),
          inside(lighting.finishes[object->back]) {}

    /// What a side is made of.
    struct Coat : Finish {
        explicit Coat(const Finish& finish) : Finish(finish), color(std::get<Color>(diffuse)) {}

        Color color;  // diffuse, all over
    };

    /// The point of its surface next to where a ray met it.
    SurfacePoint point(const Vec3d& near) const {
        auto [position, error, normal] = surface.at(near);
        return {.position = position,
                .error = error,
                .normal = normal,
                .shading_normal = normal,
                .object = object,
                .primitive = {number, 0}};
    }

    const Object* object;
    std::uint32_t number;
    sphere_filter::Ball ball;
    SpherePosition surface;
    Coat outside, inside;
};

}  // namespace raylab
