#include "raylab/geometry/surface/surface_plane.h"

#include "raylab/geometry/predicate/flat_intersection.h"

#include <cstddef>

namespace raylab {

using detail::size_of;

// This does not call scaled_to_largest_one(), which asserts: a polygon without area is prepared, too, but never hit.
SurfacePlane::SurfacePlane(const Vec3d& point, const Vec3d& normal)
    : point_(point),
      normal_(normal / largest_coordinate(normal)),
      square_(dot(normal_, normal_)),
      unit_normal_(glm::normalize(normal_)),
      size_(size_of(point)) {}

SurfacePlane::SurfacePlane(const Plane& plane)
    : SurfacePlane(convert<double>(plane.point), convert<double>(plane.normal)) {}

SurfacePlane::SurfacePlane(const Disk& disk)
    : SurfacePlane(convert<double>(disk.center), convert<double>(disk.normal)) {}

SurfacePlane::SurfacePlane(const Annulus& annulus)
    : SurfacePlane(convert<double>(annulus.center), convert<double>(annulus.normal)) {}

// A thin polygon's normal is a small sum of large products: the plane is tilted by their rounding.
SurfacePlane::SurfacePlane(const Polygon& polygon)
    : SurfacePlane(convert<double>(polygon.vertices.front()), newell_normal<double>(polygon)) {
    const auto& v = polygon.vertices;
    double products = 0;
    for (std::size_t i = 1; i + 1 < v.size(); ++i)
        products += size_of(convert<double>(v[i]) - point_) * size_of(convert<double>(v[i + 1]) - point_);
    tilt_ = products / size_of(newell_normal<double>(polygon));
    sums_ = 1 + static_cast<double>(v.size()) / detail::roundings;
}

}  // namespace raylab
