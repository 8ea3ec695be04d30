#pragma once

#include "raylab/number/next_float.h"
#include "raylab/tracer/shading/illumination.h"
#include "raylab/tracer/shading/surface_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace raylab {

/// The way a ray that leaves a surface begins, so that it does not find that very surface again (shadow acne) and
/// passes over nothing else (lost contact shadows). The default is the lab's; chapter 06 compares the others with it.
struct RayStart {
    enum class Point {
        on_surface,  // made of the surface's own numbers (geometry/surface/surface_position.h)
        along_ray,   // origin + t direction, in floats
    } point = Point::on_surface;
    enum class Offset {
        error_bounded,  // the float point on the ray's side of the surface that is nearest to it
        none,
        fixed,   // the ray's range begins at t = amount, metres
        scaled,  // ... at amount times the point's largest coordinate
    } offset = Offset::error_bounded;
    double amount = 0;
    enum class Leaving { known, forgotten } leaving = Leaving::known;  // whether the ray says what it leaves
};

/// The start of a ray beside a surface, on the side to which `normal` points.
//
// Every coordinate is moved the way of the normal: by the bound of the point's error, then to the next float. So
// normal . (start - point) > error |normal|_1 >= error: the start lies on the ray's side of the tangent plane, surely,
// and less than a unit in the last place of each coordinate (and the error) from the point. Beyond, not merely not
// below: a point may be known exactly, and a ray that starts in a plane hits it at t = 0.
inline Vec3f start_beside(const SurfacePoint& surface, const Vec3d& normal) {
    const auto coordinate = [&](double x, double n) {
        return n == 0 ? cast<float>(x) : float_beyond(x + std::copysign(surface.error, n), n);
    };
    const Vec3d &p = surface.position, &n = normal;
    return {coordinate(p.x, n.x), coordinate(p.y, n.y), coordinate(p.z, n.z)};
}

/// The ray from `begin`, a point beside the surface. It ends where it would if it began on the surface itself: a start
/// that lies towards a light must not carry the ray past it.
inline Ray ray_begun_at(const Vec3f& begin, const SurfacePoint& surface, const Vec3d& direction, double length,
                        RayStart::Leaving leaving) {
    float end = std::numeric_limits<float>::infinity();
    if (length < std::numeric_limits<double>::infinity())
        end = cast<float>(std::max(length - dot(convert<double>(begin) - surface.position, direction), 0.0));
    return {begin,
            convert<float>(direction),
            {0, end},
            leaving == RayStart::Leaving::known ? surface.primitive : no_primitive};
}

/// The ray whose start is not error bounded: chapter 06 compares these.
Ray ray_with_other_start(const SurfacePoint& surface, const Vec3d& direction, double length, const RayStart& start,
                         const Ray& arrived, double t);

/// The ray from a surface in a unit direction, as far as `length` (metres, may be infinite). `arrived` is the ray that
/// found the surface, with its t.
inline Ray ray_from(const SurfacePoint& surface, const Vec3d& direction, double length, const RayStart& start,
                    const Ray& arrived, double t) {
    if (start.offset != RayStart::Offset::error_bounded)
        return ray_with_other_start(surface, direction, length, start, arrived, t);
    const Vec3d normal = dot(surface.normal, direction) < 0 ? -surface.normal : surface.normal;
    return ray_begun_at(start_beside(surface, normal), surface, direction, length, start.leaving);
}

/// The length of a ray to a light: slightly less than the light's distance, so that a surface on which the light lies
/// does not occlude it.
inline double length_of_shadow_ray(double distance_of_light) {
    constexpr double short_of_light = 1 - 0x1p-21;  // a direction in floats ends within 2^-23 of the distance from it
    return distance_of_light * short_of_light;
}

/// The ray to a light.
inline Ray shadow_ray(const SurfacePoint& surface, const Illumination& light, const RayStart& start, const Ray& arrived,
                      double t) {
    return ray_from(surface, light.to_light, length_of_shadow_ray(light.distance), start, arrived, t);
}

/// "error_bounded", "none", "fixed:0.01", "scaled:1e-5" with the rest as `start` has it; Error otherwise.
RayStart ray_start_from_words(const std::string& words);

}  // namespace raylab
