#include "raylab/geometry/local_frame.h"
#include "raylab/sampling/mapping/sphere_cone.h"
#include "raylab/transport/light/light_point.h"
#include "raylab/transport/light/light_shape.h"
#include "raylab/transport/light/solid_angle_pdf.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

const SphereCone all_directions(2.0);

// Where a sphere is seen from.
enum class SeenFrom { outside, surface, inside };

// A point within a millionth of the radius lies on the surface, up to the rounding of scenes to floats.
SeenFrom seen_from(const SphereLight& sphere, const Vec3d& from) {
    const double height = glm::length(from - sphere.center) / sphere.radius - 1;
    if (height > 1e-6) return SeenFrom::outside;
    return height < -1e-6 ? SeenFrom::inside : SeenFrom::surface;
}

// The farther of the points in which a line meets the sphere: from inside the only one.
Vec3d far_point(const SphereLight& sphere, const Vec3d& from, const Vec3d& direction) {
    const Vec3d way = sphere.center - from;
    const double along = dot(way, direction);
    const double square = along * along - dot(way, way) + sphere.radius * sphere.radius;
    return from + (along + std::sqrt(std::max(0.0, square))) * direction;
}

}  // namespace

double SphereLight::area() const { return 4 * std::numbers::pi * radius * radius; }

// From its own surface the sphere fills the half space inwards.
std::optional<SurfaceSample> SphereLight::sample(const Vec3d& from, const std::array<double, 2>& numbers) const {
    const auto sampled = [&](const Vec3d& point) {
        return SurfaceSample{point, glm::normalize(point - center), pdf(from, point)};
    };
    const auto [u, v] = numbers;
    switch (seen_from(*this, from)) {
        case SeenFrom::outside: {
            const auto [point, pdf] = light_point(center, radius, from, u, v);
            return SurfaceSample{point, glm::normalize(point - center), pdf};
        }
        case SeenFrom::surface: {
            const LocalFrame inwards = frame_around(glm::normalize(center - from));
            return sampled(far_point(*this, from, inwards.to_world(SphereCone(1.0).direction(u, v))));
        }
        case SeenFrom::inside:
            break;
    }
    return sampled(far_point(*this, from, all_directions.direction(u, v)));
}

double SphereLight::pdf(const Vec3d& from, const Vec3d&) const {
    switch (seen_from(*this, from)) {
        case SeenFrom::outside:
            return SphereCone::around(radius, glm::length(from - center)).pdf();
        case SeenFrom::surface:
            return SphereCone(1.0).pdf();
        case SeenFrom::inside:
            break;
    }
    return all_directions.pdf();
}

namespace {

// The matrix of cofactors: it carries the unit sphere's normals to the ellipsoid's, and areas with them.
std::array<Vec3d, 3> cofactors(const std::array<Vec3d, 3>& axes) {
    const auto& [x, y, z] = axes;
    return {cross(y, z), cross(z, x), cross(x, y)};
}

Vec3d carried(const std::array<Vec3d, 3>& columns, const Vec3d& v) {
    return v.x * columns[0] + v.y * columns[1] + v.z * columns[2];
}

// The ellipsoid at the image of a unit vector: its normal, whose length is the area there for each m^2 of the sphere.
Vec3d area_normal(const EllipsoidLight& light, const Vec3d& on_sphere) {
    const auto columns = cofactors(light.axes);
    const Vec3d normal = carried(columns, on_sphere);
    return dot(light.axes[0], columns[0]) < 0 ? -normal : normal;  // a mirrored one
}

SurfaceSample at_image(const EllipsoidLight& light, const Vec3d& from, const Vec3d& on_sphere) {
    const Vec3d point = light.center + carried(light.axes, on_sphere), normal = area_normal(light, on_sphere);
    const double stretch = glm::length(normal);
    const double by_area = all_directions.pdf() / stretch;
    return {point, normal / stretch, solid_angle_pdf(by_area, from, point, normal / stretch)};
}

}  // namespace

// Knud Thomsen's approximation (2004), at most 1.2 % off; the axes' lengths stand for the semi-axes, which they are
// unless the map shears.
double EllipsoidLight::area() const {
    constexpr double p = 1.6075;
    const double a = std::pow(glm::length(axes[0]), p), b = std::pow(glm::length(axes[1]), p),
                 c = std::pow(glm::length(axes[2]), p);
    return 4 * std::numbers::pi * std::pow((a * b + b * c + c * a) / 3, 1 / p);
}

std::optional<SurfaceSample> EllipsoidLight::sample(const Vec3d& from, const std::array<double, 2>& numbers) const {
    return at_image(*this, from, all_directions.direction(numbers[0], numbers[1]));
}

double EllipsoidLight::pdf(const Vec3d& from, const Vec3d& point) const {
    const auto columns = cofactors(axes);  // their products with a vector, over the determinant, are the inverse's
    const Vec3d way = point - center;
    const Vec3d before =
        Vec3d{dot(columns[0], way), dot(columns[1], way), dot(columns[2], way)} / dot(axes[0], columns[0]);
    return at_image(*this, from, glm::normalize(before)).pdf;
}

}  // namespace raylab
