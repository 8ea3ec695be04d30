#pragma once

#include "raylab/geometry/filter/prepared_flat.h"
#include "raylab/geometry/intersect/intersect.h"
#include "raylab/geometry/surface/sphere_position.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>

namespace raylab {

/// A shape at its place, prepared once for many rays: the one place that says which filter serves which shape. It
/// answers where a ray hits the shape first, and which point of the surface a hit is. It refers to the shape, the
/// placement and the motion (null: at rest).
class PreparedShape {
public:
    PreparedShape(const Shape& shape, const Affine& placement, const Motion* motion = nullptr);

    /// The nearest hit inside ray.range of a part (0 for a shape that is not a mesh), as intersect() on the shape finds
    /// it.
    std::optional<Candidate> intersect(const Ray& ray, std::uint32_t part, Sides sides,
                                       DecisionCounts& decisions) const;

    /// The surface position of a hit, as surface_position() on the shape computes it.
    [[gnu::always_inline]] SurfacePosition position(const Ray& ray, const Hit& hit) const {
        if (const auto* sphere = std::get_if<PreparedSphere>(&kind_)) return sphere->position(point_at(ray, hit));
        if (const auto* flat = std::get_if<Flat>(&kind_)) return (*flat)->position(point_at(ray, hit));
        return surface_position(ray, hit, *shape_, *placement_, motion());
    }

    const Shape& shape() const { return *shape_; }
    std::size_t bytes() const;  // those on the heap included

private:
    struct Unprepared {};                              // nothing is known of it beforehand
    using Flat = std::shared_ptr<const PreparedFlat>;  // apart, so that a shape takes 64 bytes and not 176
    // What a filter knows.
    using Filtered = std::variant<std::monostate, const Sphere*, const Ellipsoid*, Flat, const Cylinder*, const Cone*>;
    struct Moving {  // where it is depends on the ray
        const Motion* motion;
        Filtered translated = {};  // what it translates, if that is all it does
    };
    struct Placed;  // apart, too
    using Kind = std::variant<Unprepared, PreparedSphere, const Ellipsoid*, Flat, const Cylinder*, const Cone*,
                              std::shared_ptr<const Placed>, Moving>;
    struct Preparation;
    struct PlacedFilter;
    struct TranslatedFilter;

    FilterVerdict filter_at_rest(const Ray& ray, Sides sides) const;
    FilterVerdict in_doubles(const Ray& ray, Sides sides) const;
    std::optional<Candidate> intersect_moving(const Ray& ray, std::uint32_t part, const Moving& moving, Sides sides,
                                              DecisionCounts& decisions) const;

    const Motion* motion() const {
        const auto* moving = std::get_if<Moving>(&kind_);
        return moving ? moving->motion : nullptr;
    }
    static Moving moving_kind(const Shape& shape, const Affine& placement, const Motion& motion);
    static Filtered filtered(const Shape& shape);
    static Kind placed_kind(const Shape& shape, const Affine& placement);

    static Vec3d point_at(const Ray& ray, const Hit& hit) {
        return convert<double>(ray.origin) + hit.t * convert<double>(ray.direction);
    }

    const Shape* shape_;
    const Affine* placement_;
    Kind kind_;
};

}  // namespace raylab
