#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"

#include <array>
#include <optional>

namespace raylab {

/// A ray as a placed mesh sees it, rounded to floats. It begins where it enters the bounds of the instance: so its
/// numbers are as large as the mesh's, wherever the ray comes from, and its rounding is as small as theirs.
struct RayInMesh {
    Ray ray;
    double from, scale;  // t of the world is (t - from) scale along `ray`
    // On no axis is the point of `ray` farther than this from the exact one, at any t inside the bounds.
    float displacement;

    /// At least where t of the world is along `ray`. (A difference and a product are rounded.)
    double at_most(double t) const;
};

/// The map from the world to a placed mesh, in doubles, with a bound of its error.
class WorldToMesh {
public:
    /// Absent where the map is too close to a singular one for doubles.
    static std::optional<WorldToMesh> inverse_of(const Affine& placement);

    /// Absent where the ray does not meet the bounds of the instance between its begin and `end`. The displacement is
    /// infinite where the ray's numbers exceed floats.
    std::optional<RayInMesh> carried(const Ray& ray, double end, const Box& bounds) const;

    const Affine& placement() const { return placement_; }  // whose inverse this is

private:
    std::array<Vec3d, 3> rows_;
    Affine placement_;
    double error_;  // a coordinate of the image of v errs by at most error_ times the largest coordinate of v
};

}  // namespace raylab
