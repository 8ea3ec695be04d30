#include "raylab/geometry/gradient.h"
#include "raylab/geometry/intersect.h"
#include "raylab/geometry/local_ray.h"
#include "raylab/geometry/meet_flat.h"
#include "raylab/geometry/of_size_one.h"
#include "raylab/geometry/transformed_normal.h"

#include <cassert>

namespace raylab {

namespace {

// A normal of any length, in the shape's own coordinates, at the point where the ray is there.
struct LocalNormal {
    Vec3d point;
    Part part;

    Vec3d operator()(const Plane& plane) const { return convert<double>(plane.normal); }
    Vec3d operator()(const Disk& disk) const { return convert<double>(disk.normal); }
    Vec3d operator()(const Triangle& triangle) const {
        const Vec3d a = convert<double>(triangle.a);
        return cross(convert<double>(triangle.b) - a, convert<double>(triangle.c) - a);
    }
    Vec3d operator()(const Polygon& polygon) const { return newell_normal<double>(polygon); }
    Vec3d operator()(const std::shared_ptr<const Mesh>&) const {
        assert(!"a mesh has the normals of its triangles");
        return {};
    }
    // An apex has no gradient; the axis points away from the cone there.
    Vec3d operator()(const Cone& cone) const {
        const Vec3d normal = gradient(in<double>(cone), point, part);
        if (normal != Vec3d(0)) return normal;
        const Vec3d axis = convert<double>(cone.top) - convert<double>(cone.base);
        return cone.base_radius < cone.top_radius ? -axis : axis;
    }
    template <class Q>
    Vec3d operator()(const Q& quadric) const {
        return gradient(in<double>(quadric), point, part);
    }
};

}  // namespace

Vec3d normal_at(const Ray& ray, const Candidate& candidate, const Shape& shape, const Affine& placement) {
    const auto part = static_cast<Part>(static_cast<int>(candidate.u));
    if (placement.is_identity()) {
        const Vec3d point = convert<double>(ray.origin) + candidate.t * convert<double>(ray.direction);
        return glm::normalize(of_size_one(std::visit(LocalNormal{point, part}, shape)));
    }
    const LocalRay<double> local = local_ray<double>(ray, placement);
    const Vec3d point = (local.origin + local.direction * candidate.t) / local.scale;
    const Vec3d found = of_size_one(std::visit(LocalNormal{point, part}, shape));
    std::array<Vec3d, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) columns[i] = convert<double>(placement.columns[i]);
    return transformed_normal(columns, found);
}

}  // namespace raylab
