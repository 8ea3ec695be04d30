#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"
#include "raylab/transport/light/light_piece.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// A point of a light, as it is seen from a point that it may shine on. Whether something stands between is not asked.
struct LightSample {
    Vec3d point, normal;  // normal: unit, outward as the shape defines it
    Vec3d direction;      // unit, from the lit point to the light
    double distance;      // metres
    Color radiance;       // that the light sends from there to the lit point
    double pdf;           // per steradian at the lit point, with the choice of the light
    Primitive primitive;  // on which the point lies
};

/// The objects of a scene whose materials emit, as lights of finite area. Spheres, triangles (of meshes too) and
/// rectangles are sampled uniformly over the solid angle in which they are seen, ellipsoids, disks, annuli and other
/// polygons over their area, at their place in the scene. Which of them is sampled is chosen in proportion to its
/// power.
class AreaLights {
public:
    /// An Error refuses a light of no area.
    explicit AreaLights(const Scene& scene);

    /// Whether nothing can be sampled.
    bool empty() const { return pieces_.empty(); }

    /// Whether sample() looks at `choice`: it does not where there is one light of one piece.
    bool leave_a_choice() const { return pieces_.size() > 1; }

    /// Objects that emit and cannot be sampled (planes, cylinders, cones, paraboloids, hyperboloids): their light is
    /// found only by rays that hit them. Paths for people: "cylinder 3".
    const std::vector<std::string>& unsampled() const { return unsampled_; }

    /// A point of some light, where it stands at a time. `choice` chooses the light, `numbers` the point; all in [0,
    /// 1). Absent where that light sends nothing to `from`: it counts as a sample of zero.
    std::optional<LightSample> sample(const Vec3d& from, double choice, const std::array<double, 2>& numbers,
                                      float time = 0) const;

    /// The density, per steradian at `from`, with which sample() chooses a point of this primitive that is seen from
    /// there at that time. Zero where it cannot be chosen.
    double pdf(const Vec3d& from, Primitive primitive, const Vec3d& point, float time = 0) const;

private:
    static constexpr auto none = static_cast<std::size_t>(-1);

    std::vector<LightPiece> pieces_;
    std::vector<double> chances_, ends_;  // of each piece, and the end of its interval of `choice`
    std::vector<std::size_t> first_of_;   // of each object its first piece, or none
    std::vector<std::string> unsampled_;
};

}  // namespace raylab
