#pragma once

#include "raylab/tracer/illumination.h"
#include "raylab/tracer/surface_point.h"

namespace raylab {

/// How a ray that leaves a surface begins, so that it does not find that very surface again (shadow acne) and passes over
/// nothing else (lost contact shadows). The default is the lab's; chapter 06 compares the others with it.
struct RayStart {
    enum class Point {
        on_surface,  // made of the surface's own numbers (geometry/surface_position.h)
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

/// The ray from a surface in a unit direction, as far as `length` (metres, may be infinite). `arrived` is the ray that
/// found the surface, with its t.
Ray ray_from(const SurfacePoint& surface, const Vec3d& direction, double length, const RayStart& start, const Ray& arrived,
             double t);

/// The ray to a light: as far as that, but for a hair, so that a surface which the light sits on does not hide it.
Ray feeler(const SurfacePoint& surface, const Illumination& light, const RayStart& start, const Ray& arrived, double t);

/// "error_bounded", "none", "fixed:0.01", "scaled:1e-5" with the rest as `start` has it; Error otherwise.
RayStart ray_start_from_words(const std::string& words);

}  // namespace raylab
