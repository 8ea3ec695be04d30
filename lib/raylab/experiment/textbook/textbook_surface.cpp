#include "raylab/experiment/textbook/textbook_surface.h"

#include "raylab/geometry/nearest_sphere_hit.h"
#include "raylab/geometry/triangle_hit.h"

namespace raylab {

namespace {

struct TAndNormal {
    double t;
    Vec3d normal;  // outward, of any length
};

struct RaysHitting {
    const RayOf<double>& ray;

    std::optional<TAndNormal> operator()(const Sphere& sphere) const {
        const SphereOf<double> s{convert<double>(sphere.center), cast<double>(sphere.radius)};
        const auto t = nearest_sphere_hit(ray, s);
        if (!t) return std::nullopt;
        return TAndNormal{*t, ray.origin + *t * ray.direction - s.center};
    }
    std::optional<TAndNormal> operator()(const Plane& plane) const {
        const Vec3d normal = convert<double>(plane.normal);
        const double t = dot(normal, convert<double>(plane.point) - ray.origin) / dot(normal, ray.direction);
        if (!contains(ray.range, t)) return std::nullopt;  // along the plane t is infinite or not a number
        return TAndNormal{t, normal};
    }
    std::optional<TAndNormal> operator()(const Triangle& triangle) const {
        const auto given = in<double>(triangle);
        const auto hit = triangle_hit(ray, given);
        if (!hit) return std::nullopt;
        return TAndNormal{hit->t, cross(given.b - given.a, given.c - given.a)};
    }
    template <class Other>
    std::optional<TAndNormal> operator()(const Other&) const {
        return std::nullopt;  // The textbook knows no other shapes.
    }
};

}  // namespace

std::optional<TextbookSurface> textbook_surface(const Scene& scene, const RayOf<double>& ray) {
    std::optional<TextbookSurface> nearest;
    for (const Object& object : scene.objects) {
        const auto hit_found = std::visit(RaysHitting{ray}, object.shape);
        if (!hit_found || (nearest && hit_found->t >= nearest->t)) continue;
        const Vec3d normal = glm::normalize(hit_found->normal);
        const bool outside = dot(normal, ray.direction) <= 0;
        nearest = {hit_found->t, ray.origin + hit_found->t * ray.direction, outside ? normal : -normal, outside,
                   &object};
    }
    return nearest;
}

}  // namespace raylab
