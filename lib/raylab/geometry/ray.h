#pragma once

#include "raylab/geometry/part.h"
#include "raylab/geometry/vector.h"

#include <cstdint>
#include <limits>

namespace raylab {

/// A closed range of the ray parameter t.
template <Scalar T>
struct Interval {
    T min, max;
};

/// True if t is a finite number inside the closed range. Written positively, so that NaN is outside.
template <Scalar T>
constexpr bool contains(const Interval<T>& range, const T& t) {
    return t >= range.min && t <= range.max && t < std::numeric_limits<T>::infinity();
}

/// The points origin + t direction with t in range, in the number type a method computes in. The direction need not be
/// unit and is a free vector: origin + direction is never formed.
template <Scalar T>
struct RayOf {
    Vec3<T> origin, direction;
    Interval<T> range;
};

/// One primitive of a scene: which placed object (its index in Scene::objects order, instances flattened in order), and
/// which triangle of it after fanning (0 for a shape that is not a mesh). Ordered as ties are: the lower wins.
struct Primitive {
    std::uint32_t object = 0;
    std::uint32_t part = 0;

    friend auto operator<=>(const Primitive&, const Primitive&) = default;
};

/// "This ray leaves no surface": eye rays, light rays.
inline constexpr Primitive no_primitive{std::numeric_limits<std::uint32_t>::max(),
                                        std::numeric_limits<std::uint32_t>::max()};

/// A ray of the lab, as it crosses the seam: floats, whatever computed them, so that every decision about it has an
/// exact answer. Only the ends of its range may be infinite, and no number is NaN.
struct Ray {
    Vec3f origin, direction;
    Interval<float> range{0.0f, std::numeric_limits<float>::infinity()};
    Primitive leaving = no_primitive;  // a flat primitive is not hit again by a ray that leaves it
    float time = 0;                    // in seconds: where moving objects stand when it passes
};

/// The ray as a method computes with it.
template <Scalar T>
RayOf<T> in(const Ray& ray) {
    return {convert<T>(ray.origin), convert<T>(ray.direction), {cast<T>(ray.range.min), cast<T>(ray.range.max)}};
}

/// The nearest hit, small: position, normal and material are computed from it on request.
struct Hit {
    double t;  // rounded to float, within one ulp of the exact value: infinite where that is beyond the floats, and a
               // hit all the same
    Primitive primitive;
    double u = 0, v = 0;  // triangles: weights of the second and third vertex
    Part part = Part::side;
};

}  // namespace raylab
