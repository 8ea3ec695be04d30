#pragma once

#include "raylab/geometry/flat_position.h"

#include <variant>

namespace raylab {

/// A shape at its place, for many hits: what it is, and of spheres and flat shapes at rest where they were made what does not
/// depend on the ray, is found out once. It refers to the shape and the placement.
class PreparedSurface {
public:
    PreparedSurface(const Shape& shape, const Affine& placement);

    /// What surface_position() says.
    [[gnu::always_inline]] SurfacePosition position(const Ray& ray, const Hit& hit) const {
        if (const auto* sphere = std::get_if<SpherePosition>(&kind_)) return sphere->at(near(ray, hit));
        if (const auto* flat = std::get_if<FlatPosition>(&kind_)) return flat->at(near(ray, hit));
        return position_of_other(ray, hit);
    }

private:
    struct Other {
        const Shape* shape;
        const Affine* placement;
    };

    SurfacePosition position_of_other(const Ray& ray, const Hit& hit) const;
    static Vec3d near(const Ray& ray, const Hit& hit) {
        return convert<double>(ray.origin) + hit.t * convert<double>(ray.direction);
    }

    std::variant<Other, SpherePosition, FlatPosition> kind_;
};

}  // namespace raylab
