#include "surfaces.h"

#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab::lighting {

namespace {

constexpr double turn = 2 * std::numbers::pi;

TwoWaySurface ellipsoid(const Vec3d& radii) {
    const auto point = [=](double u, double v) {
        const double a = turn * u, b = std::numbers::pi * v;
        return radii * Vec3d{std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), -std::cos(b)};
    };
    return {
        .name = "ellipsoid",
        .point = point,
        .by_gradient = [=](double u, double v) { return glm::normalize(point(u, v) / (radii * radii)); },
        .by_tangents =
            [=](double u, double v) {
                const double a = turn * u, b = std::numbers::pi * v;
                const Vec3d along_u = radii * Vec3d{-std::sin(a) * std::sin(b), std::cos(a) * std::sin(b), 0};
                const Vec3d along_v = radii * Vec3d{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
                return glm::normalize(cross(along_u, along_v));
            }};
}

TwoWaySurface torus(double tube) {
    const auto point = [=](double u, double v) {
        const double a = turn * u, b = turn * v, out = 1 + tube * std::cos(b);
        return Vec3d{out * std::cos(a), out * std::sin(a), tube * std::sin(b)};
    };
    return {.name = "torus",
            .point = point,
            .by_gradient =
                [=](double u, double v) {
                    const Vec3d p = point(u, v);
                    const double out = std::hypot(p.x, p.y), pull = (out - 1) / out;
                    return glm::normalize(Vec3d{p.x * pull, p.y * pull, p.z});
                },
            .by_tangents =
                [=](double u, double v) {
                    const double a = turn * u, b = turn * v, out = 1 + tube * std::cos(b);
                    const Vec3d along_u{-out * std::sin(a), out * std::cos(a), 0};
                    const Vec3d along_v{-std::sin(b) * std::cos(a), -std::sin(b) * std::sin(a), std::cos(b)};
                    return glm::normalize(cross(along_u, along_v));
                }};
}

TwoWaySurface cylinder(double radius) {
    const auto point = [=](double u, double v) {
        return Vec3d{radius * std::cos(turn * u), radius * std::sin(turn * u), v};
    };
    return {.name = "cylinder",
            .point = point,
            .by_gradient =
                [=](double u, double v) {
                    const Vec3d p = point(u, v);
                    return glm::normalize(Vec3d{p.x, p.y, 0});
                },
            .by_tangents =
                [=](double u, double) {
                    return glm::normalize(cross(Vec3d{-std::sin(turn * u), std::cos(turn * u), 0}, Vec3d{0, 0, 1}));
                }};
}

double angle(const Vec3d& a, const Vec3d& b) { return 2 * std::asin(std::min(1.0, glm::length(a - b) / 2)); }

}  // namespace

std::vector<TwoWaySurface> two_way_surfaces() { return {ellipsoid({1, 0.7, 0.5}), torus(0.4), cylinder(0.5)}; }

Vec3d by_three_points(const TwoWaySurface& surface, double u, double v, double step) {
    const Vec3d a = surface.point(u, v);
    return glm::normalize(cross(surface.point(u + step, v) - a, surface.point(u, v + step) - a));
}

double worst_lean(const TwoWaySurface& surface, const NormalWay& way, std::uint64_t seed) {
    constexpr int points = 1000;
    double worst = 0;
    RandomSequence random(seed, 0);
    for (int i = 0; i < points; ++i) {
        const double u = random.next();
        const double v = random.between(0.1, 0.8);  // away from the ellipsoid's poles, which have no tangent along u
        worst = std::max(worst, angle(surface.by_gradient(u, v), way(u, v)));
    }
    return worst;
}

double worst_lean_by_three_points(const TwoWaySurface& surface, double step, std::uint64_t seed) {
    return worst_lean(
        surface, [&](double u, double v) { return by_three_points(surface, u, v, step); }, seed);
}

}  // namespace raylab::lighting
