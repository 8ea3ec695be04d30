#include "case_examples.h"

#include "raylab/report/case_drawings.h"
#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace raylab {

namespace {

using namespace plane_ink;

constexpr PlaneStyle solid_style{.line = blue, .fill = pale_blue, .width = 2};

// Less than zero inside of the solid, and its middle.
struct Solid {
    std::function<double(const Vec3d&)> level;
    Vec3d middle;
    double size;  // no point of it is farther from the middle
};

Solid solid_of(const Vec3d& center, const Vec3d& radii) {
    return {[=](const Vec3d& p) {
                const Vec3d q = (p - center) / radii;
                return dot(q, q) - 1;
            },
            center, std::max({radii.x, radii.y, radii.z})};
}

Solid solid_of(const Revolution<double>& surface) {
    const double length_squared = dot(surface.axis, surface.axis);
    const double widest = std::max({surface.squared_radius(0), surface.squared_radius(0.5), surface.squared_radius(1)});
    return {[=](const Vec3d& p) {
                const double s = dot(p - surface.base, surface.axis) / length_squared;
                const Vec3d aside = p - surface.base - s * surface.axis;
                return std::max({dot(aside, aside) - surface.squared_radius(s), -s, s - 1});
            },
            surface.base + 0.5 * surface.axis, std::sqrt(length_squared / 4 + widest)};
}

Solid solid_of(const Quadric& quadric) {
    if (const auto* sphere = std::get_if<Sphere>(&quadric))
        return solid_of(convert<double>(sphere->center), Vec3d(double{sphere->radius}));
    if (const auto* ellipsoid = std::get_if<Ellipsoid>(&quadric))
        return solid_of(convert<double>(ellipsoid->center), convert<double>(ellipsoid->radii));
    return std::visit(
        [](const auto& one) -> Solid {
            if constexpr (requires { in<double>(one).axis; }) return solid_of(in<double>(one));
            return {};  // handled above
        },
        quadric);
}

// Seen from its middle, each of these solids' sections shows all of its outline: so a radius for each angle will do.
PlanePolygon outline_of(const Solid& solid, const CasePlane& plane) {
    constexpr int angles = 360, halvings = 30;
    PlanePolygon outline;
    for (int i = 0; i < angles; ++i) {
        const double angle = 2 * std::numbers::pi * i / angles;
        const Vec3d way = std::cos(angle) * plane.right + std::sin(angle) * plane.up;
        double inside = 0, outside = 1.01 * solid.size;
        for (int k = 0; k < halvings; ++k) {
            const double middle = (inside + outside) / 2;
            (solid.level(solid.middle + middle * way) < 0 ? inside : outside) = middle;
        }
        outline.corners.push_back(plane.at(solid.middle + inside * way));
    }
    return outline;
}

std::string name_of(const Quadric& quadric) {
    constexpr const char* names[] = {"sphere", "ellipsoid", "cylinder", "cone", "paraboloid", "hyperboloid"};
    return names[quadric.index()];
}

}  // namespace

CaseExample example_of(const Ray& ray, const Quadric& quadric, TrueAnswer truth) {
    const RayOf<double> way = in<double>(ray);
    const Solid solid = solid_of(quadric);
    CasePlane plane = plane_along(way, solid.middle - way.origin);
    plane.origin = solid.middle;
    const PlanePoint start = plane.at(way.origin);
    const double left = std::max(start.x, -1.5 * solid.size), right = std::max(1.5 * solid.size, left);
    PlaneSketch sketch;
    sketch.add(outline_of(solid, plane), solid_style);
    sketch.arrow({left, start.y}, {right, start.y}, stroke(vermilion, 2));
    auto drawing = case_drawing_around({{-1.5 * solid.size, -solid.size}, {1.5 * solid.size, solid.size}});
    drawing.marks = sketch.marks();
    drawing.notes = {"A cut through ray and middle.",
                     truth == TrueAnswer::hit ? "In truth it hits." : "In truth it misses."};
    return {in_words(ray) + ", " + name_of(quadric), drawing};
}

CaseExample example_of_floor(const Ray& ray, const Sphere& sphere, double t, double given) {
    const RayOf<double> way = in<double>(ray);
    const auto [center, radius] = in<double>(sphere);
    const Vec3d up = glm::normalize(way.origin - center), foot = center + radius * up;
    const CasePlane plane{foot, plane_along({foot, up, {0, 1}}, way.direction).up, up};
    const PlanePoint eye = plane.at(way.origin), hit = plane.at(way.origin + t * way.direction),
                     found = plane.at(way.origin + given * way.direction);
    const double far = 1.3 * std::max({hit.x, found.x, eye.y});
    std::vector<PlanePoint> ground;
    for (int i = -5; i <= 20; ++i) {
        const double x = std::clamp(far * i / 20, -radius, radius);
        ground.push_back({x, std::sqrt(radius * radius - x * x) - radius});
    }
    PlaneSketch sketch;
    sketch.path(ground, stroke(blue, 3));
    sketch.line(eye, found, stroke(vermilion, 2, dashed));
    sketch.line(eye, hit, stroke(vermilion, 2));
    sketch.dot(eye, 4);
    sketch.dot(hit, 4, blue);
    sketch.dot(found, 5, vermilion);
    sketch.words(eye, "eye", {.aside = {8, -2}});
    auto drawing = case_drawing_around({eye, hit, found, ground.front(), ground.back()});
    drawing.marks = sketch.marks();
    drawing.notes = {fmt::format("It hits at t = {:.4g}; the method says {:.4g}", t, given), "(the larger dot)."};
    return {in_words(ray), drawing};
}

}  // namespace raylab
