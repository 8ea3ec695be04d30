#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/largest_coordinate.h"
#include "raylab/tracer/shading/surface_point.h"

#include <algorithm>
#include <cmath>
#include <memory>

// Scenes in which shadow rays are hard to start: every kind of shape at many scales and places, with things hovering
// closely above it.

namespace raylab::shadow_rays {

using adversarial::Draw;

// A scene of this size, so far from the origin.
struct Where {
    double scale, away;
    Vec3d center() const { return Vec3d{1, 0.7, -0.4} * away; }
};

// The spacing of floats at a point's largest coordinate.
inline double ulp_at(const Vec3d& p) {
    const float size = cast<float>(largest_coordinate(p));
    return double{std::nextafter(size, 1e30f)} - size;
}

// The places where a scene is at least a hundred floats wide: in a smaller one nothing is left to see.
inline std::vector<Where> places() {
    std::vector<Where> all;
    for (const double scale : {1e-3, 1.0, 1e3})
        for (const double away : {0.0, 1e3, 1e5})
            if (const Where where{scale, away}; scale >= 100 * ulp_at(where.center() + Vec3d(scale)))
                all.push_back(where);
    return all;
}

inline Vec3d direction(Draw& draw) {
    for (;;) {
        const Vec3d v{draw.number(-1, 1), draw.number(-1, 1), draw.number(-1, 1)};
        if (const double square = dot(v, v); square > 1e-3 && square < 1) return v / std::sqrt(square);
    }
}

enum class Kind {
    sphere,
    ellipsoid,
    cylinder,
    cone,
    paraboloid,
    hyperboloid,
    plane,
    disk,
    polygon,
    triangle,
    convex,
    concave,
    annulus
};
constexpr int kinds = 13;

// A shape about the center, as large as the scale.
inline Shape shape(Kind kind, const Vec3d& center, double scale, Draw& draw) {
    const auto at = [&](const Vec3d& v) { return convert<float>(center + scale * v); };
    const auto length = [&](double x) { return cast<float>(scale * x); };
    const Vec3d axis = direction(draw), across = glm::normalize(cross(axis, direction(draw))),
                third = cross(axis, across);
    const Ends ends = draw.one_in(2) ? Ends::capped : Ends::open;
    const auto corner = [&](double x, double y) { return at(across * x + third * y); };
    const auto mesh = [&](Mesh made) {
        for (Vec3f& v : made.vertices) v = at(convert<double>(v) * 0.8);
        return std::make_shared<const Mesh>(std::move(made));
    };
    switch (kind) {
        case Kind::sphere:
            return Sphere{at({0, 0, 0}), length(1)};
        case Kind::ellipsoid:
            return Ellipsoid{at({0, 0, 0}), {length(1), length(draw.number(0.05, 1)), length(0.4)}};
        case Kind::cylinder:
            return Cylinder{at(-axis), at(axis), length(draw.number(0.05, 1)), ends};
        case Kind::cone:
            return Cone{at(-axis), at(axis), length(draw.number(0.1, 1)), draw.one_in(2) ? 0 : length(0.3), ends};
        case Kind::paraboloid:
            return Paraboloid{at(-axis), at(axis), length(draw.number(0.1, 1)), ends};
        case Kind::hyperboloid:
            return Hyperboloid{at(-axis), at(axis), length(draw.number(0.02, 0.5)), length(1), ends};
        case Kind::plane:
            return Plane{at({0, 0, 0}), convert<float>(axis)};
        case Kind::disk:
            return Disk{at({0, 0, 0}), convert<float>(axis), length(1)};
        case Kind::polygon:
            return Polygon{{corner(-1, -1), corner(1, -1), corner(0.1, 0), corner(1, 1), corner(-1, 0.6)}};
        case Kind::triangle:
            return Triangle{corner(-1, -1), corner(1, -0.8), corner(draw.number(-1, 1), 1)};
        case Kind::convex:
            return mesh(icosphere(1));
        case Kind::concave:
            return mesh(draw.one_in(2) ? bumpy_sphere(2, 0.4, 4) : torus(0.3, 2));
        case Kind::annulus:
            return Annulus{at({0, 0, 0}), convert<float>(axis), length(draw.number(0.1, 0.9)), length(1)};
    }
    return {};
}

// Turned, sheared and stretched about its center, which it leaves where it is.
inline Affine sheared(const Vec3d& center, Draw& draw) {
    const auto turn = AffineSteps::rotate(direction(draw), draw.number(0, 360));
    AffineSteps shear;
    shear.columns = {Vec3d{draw.number(0.5, 1.5), 0, 0}, Vec3d{draw.number(-1, 1), draw.number(-1.2, -0.4), 0},
                     Vec3d{draw.number(-1, 1), 0.3, draw.number(0.3, 1.2)}};
    return AffineSteps::translate(-center).then(turn).then(shear).then(AffineSteps::translate(center)).rounded();
}

// A scene, rays aimed at it, and where something hovers closely over it.
struct Stage {
    Where where;
    Scene scene;
    std::vector<Vec3d> feet;  // points under hovering things
    double hovering = 0;      // how large they are

    Vec3d anywhere(Draw& draw) const {
        return where.center() + where.scale * Vec3d{draw.number(-1, 1), draw.number(-1, 1), draw.number(-1, 1)};
    }
    Ray aimed(Draw& draw) const {
        const Vec3d target = feet.empty() || draw.one_in(3) ? anywhere(draw)
                                                            : feet[std::size_t(draw.integer(0, int(feet.size()) - 1))] +
                                                                  direction(draw) * (hovering * draw.number(0, 1.5));
        const double distance = draw.one_in(3) ? 0.7 : std::pow(10, draw.number(0.1, 3.5));
        return adversarial::through(convert<float>(where.center() + direction(draw) * (where.scale * distance)),
                                    target);
    }
};

struct Found {
    Ray ray;
    Hit hit;
    SurfacePoint at;
    Vec3d normal;  // on the ray's side
};

inline std::optional<Found> found(const Scene& scene, const Accelerator& accelerator, const Ray& ray) {
    Traversal traversal;
    const auto hit = accelerator.closest(ray, traversal);
    if (!hit) return std::nullopt;
    const SurfacePoint at = surface_point(scene, ray, *hit);
    return Found{ray, *hit, at, facing(at.normal, convert<double>(ray.direction))};
}

// Parallel to the surface, 8 to 50 floats over it.
inline Shape hovering(const Found& foot, double gap, double size, Draw& draw) {
    const Vec3d across = glm::normalize(cross(foot.normal, direction(draw))), third = cross(foot.normal, across);
    const Vec3d over = foot.at.position + foot.normal * gap;
    if (draw.one_in(3)) return Sphere{convert<float>(over + foot.normal * size), cast<float>(size)};
    const auto corner = [&](double x, double y) { return convert<float>(over + (across * x + third * y) * size); };
    return Triangle{corner(-1, -1), corner(1, -1), corner(0, 1)};
}

inline Stage stage(Where where, Kind kind, Draw& draw) {
    Stage stage{.where = where};
    const Vec3d center = where.center();
    const auto placement = [&] { return draw.one_in(3) ? sheared(center, draw) : Affine{}; };
    stage.scene.materials = {{}};
    stage.scene.objects.push_back({.shape = shape(kind, center, where.scale, draw), .placement = placement()});
    const auto alone = make_accelerator("list", stage.scene);
    std::vector<Shape> above;
    for (int tries = 0; tries < 40 && above.size() < 2; ++tries) {
        const auto foot = found(stage.scene, *alone, stage.aimed(draw));
        if (!foot) continue;
        const double gap = ulp_at(foot->at.position) * draw.number(9, 50);
        stage.hovering = std::min(gap * draw.number(3, 30), 0.3 * where.scale);
        above.push_back(hovering(*foot, gap, stage.hovering, draw));
        stage.feet.push_back(foot->at.position);
    }
    for (const Shape& hovers : above) stage.scene.objects.push_back({.shape = hovers});
    stage.scene.objects.push_back({.shape = Sphere{convert<float>(center + direction(draw) * (2.2 * where.scale)),
                                                   cast<float>(0.6 * where.scale)}});
    return stage;
}

}  // namespace raylab::shadow_rays
