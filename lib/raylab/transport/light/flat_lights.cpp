#include "raylab/sampling/mapping/concentric_disk.h"
#include "raylab/sampling/mapping/spherical_rectangle.h"
#include "raylab/sampling/mapping/spherical_triangle.h"
#include "raylab/transport/light/light_shape.h"
#include "raylab/transport/light/solid_angle_pdf.h"

#include <cmath>
#include <numbers>

namespace raylab {

namespace {

// Whether a point lies in a flat light's plane, up to the rounding of scenes to floats: there it is lit by none of it.
bool is_in_plane(const Vec3d& from, const Vec3d& point, const Vec3d& area_vector) {
    const double area = glm::length(area_vector);
    return std::abs(dot(point - from, area_vector)) <= 1e-6 * area * std::sqrt(area);
}

// A point of a flat light that is sampled by area.
std::optional<SurfaceSample> by_area(const Vec3d& area_vector, const Vec3d& from, const Vec3d& point) {
    if (is_in_plane(from, point, area_vector)) return std::nullopt;
    const double area = glm::length(area_vector);
    const Vec3d normal = area_vector / area;
    return SurfaceSample{point, normal, solid_angle_pdf(1 / area, from, point, normal)};
}

double pdf_by_area(const Vec3d& area_vector, const Vec3d& from, const Vec3d& point) {
    const auto sample = by_area(area_vector, from, point);
    return sample ? sample->pdf : 0;
}

template <class Triangle>
Vec3d triangle_area_vector(const Triangle& triangle) {
    return 0.5 * cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

// Uniform by area: the square root is the share of the way from a to the opposite side.
template <class Triangle>
Vec3d uniform_point(const Triangle& triangle, const std::array<double, 2>& numbers) {
    const double away = std::sqrt(numbers[0]), along = away * numbers[1];
    return triangle.a + (away - along) * (triangle.b - triangle.a) + along * (triangle.c - triangle.a);
}

Vec3d rectangle_area_vector(const RectangleLight& light) { return cross(light.first, light.second); }

Vec3d disk_area_vector(const DiskLight& light) {
    return std::numbers::pi * (1 - light.inner * light.inner) * cross(light.first, light.second);
}

SphericalTriangle seen(const TriangleLight& light, const Vec3d& from) {
    return {light.a - from, light.b - from, light.c - from};
}

// Absent where it cannot be sampled by solid angle.
std::optional<SphericalRectangle> seen(const RectangleLight& light, const Vec3d& from) {
    const auto& [corner, first, second] = light;
    const bool is_sheared = std::abs(dot(first, second)) > 1e-6 * glm::length(first) * glm::length(second);
    if (is_sheared) return std::nullopt;
    const SphericalRectangle rectangle(from, corner, first, second);
    if (!(rectangle.solid_angle() > SphericalRectangle::smallest)) return std::nullopt;
    return rectangle;
}

}  // namespace

double TriangleLight::area() const { return glm::length(triangle_area_vector(*this)); }

std::optional<SurfaceSample> TriangleLight::sample(const Vec3d& from, const std::array<double, 2>& numbers) const {
    const Vec3d area_vector = triangle_area_vector(*this);
    if (is_in_plane(from, a, area_vector)) return std::nullopt;
    const SphericalTriangle triangle = seen(*this, from);
    if (!(triangle.solid_angle() > SphericalTriangle::smallest))
        return by_area(area_vector, from, uniform_point(*this, numbers));
    const Vec3d direction = triangle.direction(numbers[0], numbers[1]);
    const double distance = dot(a - from, area_vector) / dot(direction, area_vector);
    return SurfaceSample{from + distance * direction, glm::normalize(area_vector), triangle.pdf()};
}

double TriangleLight::pdf(const Vec3d& from, const Vec3d& point) const {
    const Vec3d area_vector = triangle_area_vector(*this);
    if (is_in_plane(from, a, area_vector)) return 0;
    const SphericalTriangle triangle = seen(*this, from);
    return triangle.solid_angle() > SphericalTriangle::smallest ? triangle.pdf()
                                                                : pdf_by_area(area_vector, from, point);
}

double RectangleLight::area() const { return glm::length(rectangle_area_vector(*this)); }

std::optional<SurfaceSample> RectangleLight::sample(const Vec3d& from, const std::array<double, 2>& numbers) const {
    if (is_in_plane(from, corner, rectangle_area_vector(*this))) return std::nullopt;
    const auto [u, v] = numbers;
    const auto rectangle = seen(*this, from);
    if (!rectangle) return by_area(rectangle_area_vector(*this), from, corner + u * first + v * second);
    return SurfaceSample{rectangle->point(u, v), glm::normalize(rectangle_area_vector(*this)), rectangle->pdf()};
}

double RectangleLight::pdf(const Vec3d& from, const Vec3d& point) const {
    if (is_in_plane(from, corner, rectangle_area_vector(*this))) return 0;
    const auto rectangle = seen(*this, from);
    return rectangle ? rectangle->pdf() : pdf_by_area(rectangle_area_vector(*this), from, point);
}

double PolygonLight::area() const { return glm::length(triangle_area_vector(*this)); }

std::optional<SurfaceSample> PolygonLight::sample(const Vec3d& from, const std::array<double, 2>& numbers) const {
    return by_area(triangle_area_vector(*this), from, uniform_point(*this, numbers));
}

double PolygonLight::pdf(const Vec3d& from, const Vec3d& point) const {
    return pdf_by_area(triangle_area_vector(*this), from, point);
}

double DiskLight::area() const { return glm::length(disk_area_vector(*this)); }

// A ring is the disk whose squared radii are squeezed into [inner^2, 1]. (The centre alone stays where it is.)
std::optional<SurfaceSample> DiskLight::sample(const Vec3d& from, const std::array<double, 2>& numbers) const {
    const auto [x, y] = concentric_disk(numbers[0], numbers[1]);
    const double squared = x * x + y * y, hole = inner * inner;
    const double outward = squared > 0 ? std::sqrt((hole + (1 - hole) * squared) / squared) : 1;
    return by_area(disk_area_vector(*this), from, center + outward * (x * first + y * second));
}

double DiskLight::pdf(const Vec3d& from, const Vec3d& point) const {
    return pdf_by_area(disk_area_vector(*this), from, point);
}

}  // namespace raylab
