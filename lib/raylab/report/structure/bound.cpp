#include "raylab/report/structure/bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

bool equal(const Box& a, const Box& b) { return a.min == b.min && a.max == b.max; }
bool equal(const Sphere& a, const Sphere& b) { return a.center == b.center && a.radius == b.radius; }
bool equal(const OrientedBox& a, const OrientedBox& b) { return a.center == b.center && a.half_axes == b.half_axes; }

/// The part of a ray that is left after clipping by slabs.
struct Cut {
    double from, to;

    // Clips to the t where low <= position + t step <= high.
    void slab(double position, double step, double low, double high) {
        if (step == 0) {
            if (position < low || position > high) to = -std::numeric_limits<double>::infinity();
            return;
        }
        const double a = (low - position) / step, b = (high - position) / step;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
};

void cut(Cut& span, const RayOf<double>& ray, const Box& box) {
    for (int axis = 0; axis < 3; ++axis)
        span.slab(ray.origin[axis], ray.direction[axis], double{box.min[axis]}, double{box.max[axis]});
}

void cut(Cut& span, const RayOf<double>& ray, const OrientedBox& box) {
    const Vec3d from = ray.origin - convert<double>(box.center);
    for (const Vec3f& half : box.half_axes) {
        const Vec3d axis = convert<double>(half);
        const double squared = dot(axis, axis);
        span.slab(dot(from, axis), dot(ray.direction, axis), -squared, squared);
    }
}

void cut(Cut& span, const RayOf<double>& ray, const Sphere& sphere) {
    const Vec3d from = ray.origin - convert<double>(sphere.center);
    const double a = dot(ray.direction, ray.direction), b = dot(from, ray.direction);
    const double root = b * b - a * (dot(from, from) - double{sphere.radius} * sphere.radius);
    if (root < 0) span.to = -std::numeric_limits<double>::infinity();
    span.from = std::max(span.from, (-b - std::sqrt(std::max(0.0, root))) / a);
    span.to = std::min(span.to, (-b + std::sqrt(std::max(0.0, root))) / a);
}

std::string text(const Vec3f& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

std::string in_words(const Box& box) {
    return fmt::format("x {:.4g}..{:.4g}, y {:.4g}..{:.4g}, z {:.4g}..{:.4g}", box.min.x, box.max.x, box.min.y,
                       box.max.y, box.min.z, box.max.z);
}
std::string in_words(const Sphere& sphere) {
    return fmt::format("center {}, radius {:.4g}", text(sphere.center), sphere.radius);
}
std::string in_words(const OrientedBox& box) {
    return fmt::format("center {}, half axes {}, {}, {}", text(box.center), text(box.half_axes[0]),
                       text(box.half_axes[1]), text(box.half_axes[2]));
}

}  // namespace

bool same(const Bound& a, const Bound& b) {
    if (a.index() != b.index()) return false;
    return std::visit([&](const auto& of_a) { return equal(of_a, std::get<std::decay_t<decltype(of_a)>>(b)); }, a);
}

std::optional<Interval<double>> span_inside(const Ray& ray, const Bound& bound) {
    const RayOf<double> line = in<double>(ray);
    Cut span{line.range.min, line.range.max};
    std::visit([&](const auto& of_bound) { cut(span, line, of_bound); }, bound);
    if (!(span.from <= span.to)) return std::nullopt;
    return Interval<double>{span.from, span.to};
}

Box box_about(const Bound& bound) {
    if (const auto* box = std::get_if<Box>(&bound)) return *box;
    if (const auto* sphere = std::get_if<Sphere>(&bound))
        return {sphere->center - sphere->radius, sphere->center + sphere->radius};
    const auto& [center, axes] = std::get<OrientedBox>(bound);
    const Vec3f half = glm::abs(axes[0]) + glm::abs(axes[1]) + glm::abs(axes[2]);
    return {center - half, center + half};
}

std::string words(const Bound& bound) {
    return std::visit([](const auto& of_bound) { return in_words(of_bound); }, bound);
}

}  // namespace raylab
