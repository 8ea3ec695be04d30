#include "contact_sheet.h"

#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/geometry/affine.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace raylab;
using adversarial::Draw;

namespace {

constexpr double cell = 2.5;  // metres, about the extent of a placed shape
constexpr int cell_pixels = 64;
constexpr Sides all_sides[] = {Sides::both, Sides::front, Sides::back};

Vec3d unit(Draw& draw) { return glm::normalize(convert<double>(draw.in_cube(1)) + Vec3d(0, 0, 1e-3)); }

Ends any_ends(Draw& draw) { return draw.one_in(2) ? Ends::open : Ends::capped; }

struct Axis {
    Vec3f base, top;
};

Axis any_axis(Draw& draw, const Vec3f& center) {
    const Vec3f half = convert<float>(0.7 * unit(draw));
    return {center - half, center + half};
}

// A star, which has convex and concave corners.
Polygon any_polygon(Draw& draw, const Vec3f& center) {
    const Vec3d normal = unit(draw), across = glm::normalize(cross(normal, unit(draw))), along = cross(normal, across);
    Polygon polygon;
    for (int i = 0; i < 7; ++i) {
        const double angle = 2 * std::numbers::pi * i / 7, reach = draw.number(0.3, 1);
        polygon.vertices.push_back(center +
                                   convert<float>(reach * (std::cos(angle) * across + std::sin(angle) * along)));
    }
    return polygon;
}

Triangle any_triangle(Draw& draw, const Vec3f& center) {
    return {center + draw.in_cube(1.2), center + draw.in_cube(1.2), center + draw.in_cube(1.2)};
}

using Kind = std::function<Shape(Draw&, const Vec3f& center)>;
using Placement = std::function<AffineSteps(Draw&)>;

const std::vector<Kind> kinds = {
    [](Draw& draw, const Vec3f& at) {
        return Sphere{at, draw.uniform(0.5, 1)};
    },
    [](Draw& draw, const Vec3f& at) {
        return Ellipsoid{at, {draw.uniform(0.3, 1), draw.uniform(0.3, 1), draw.uniform(0.3, 1)}};
    },
    [](Draw& draw, const Vec3f& at) {
        const auto [base, top] = any_axis(draw, at);
        return Cylinder{base, top, draw.uniform(0.2, 0.7), any_ends(draw)};
    },
    [](Draw& draw, const Vec3f& at) {
        const auto [base, top] = any_axis(draw, at);
        return Cone{base, top, draw.uniform(0.3, 0.7), draw.one_in(2) ? 0 : draw.uniform(0.1, 0.7), any_ends(draw)};
    },
    [](Draw& draw, const Vec3f& at) {
        const auto [base, top] = any_axis(draw, at);
        return Paraboloid{base, top, draw.uniform(0.3, 0.7), any_ends(draw)};
    },
    [](Draw& draw, const Vec3f& at) {
        const auto [base, top] = any_axis(draw, at);
        return Hyperboloid{base, top, draw.uniform(0.1, 0.4), draw.uniform(0.5, 0.7), any_ends(draw)};
    },
    [](Draw& draw, const Vec3f& at) {
        return Disk{at, convert<float>(unit(draw)), draw.uniform(0.5, 1)};
    },
    [](Draw& draw, const Vec3f& at) {
        return Annulus{at, convert<float>(unit(draw)), draw.uniform(0.1, 0.4), draw.uniform(0.5, 1)};
    },
    [](Draw& draw, const Vec3f& at) { return any_polygon(draw, at); },
    [](Draw& draw, const Vec3f& at) { return any_triangle(draw, at); },
    [](Draw& draw, const Vec3f& at) {
        return mesh_of({any_triangle(draw, at), any_triangle(draw, at), any_triangle(draw, at)});
    },
};

AffineSteps any_rotation(Draw& draw) { return AffineSteps::rotate(unit(draw), draw.number(0, 360)); }

AffineSteps shear(Draw& draw) {
    AffineSteps steps;
    steps.columns[1].x = draw.number(-0.8, 0.8);
    steps.columns[2].y = draw.number(-0.8, 0.8);
    return steps;
}

const std::vector<Placement> placements = {
    [](Draw&) { return AffineSteps{}; },
    [](Draw& draw) { return any_rotation(draw); },
    [](Draw& draw) {
        return AffineSteps::scale({-1, 1, 1}).then(any_rotation(draw));
    },
    [](Draw& draw) {
        return AffineSteps::scale({draw.number(0.4, 1.6), draw.number(0.4, 1.6), draw.number(0.4, 1.6)});
    },
    [](Draw& draw) { return shear(draw).then(any_rotation(draw)); },
};

Object object(const Shape& shape, const Affine& placement, Sides sides, Draw& draw) {
    return {.shape = shape,
            .placement = placement,
            .front = static_cast<std::size_t>(draw.integer(0, 1)),
            .back = static_cast<std::size_t>(draw.integer(2, 3)),
            .sides = sides};
}

// A shape without a transform has coordinates at its place.
Object object_at(const Vec3d& middle, const Kind& kind, const Placement& placement, Sides sides, Draw& draw) {
    const Affine affine = placement(draw).rounded();
    if (affine.is_identity()) return object(kind(draw, convert<float>(middle)), affine, sides, draw);
    const Affine moved = AffineSteps::of(affine).then(AffineSteps::translate(middle)).rounded();
    return object(kind(draw, Vec3f(0)), moved, sides, draw);
}

Material material(const Color& color) {
    return {.ambient = 0.3 * color, .diffuse = color, .specular = Color(0.3), .shininess = 12};
}

Scene lit_scene() {
    Scene scene;
    scene.background = {{0.2, 0.3, 0.5}, {0.2, 0.2, 0.2}};
    scene.materials = {material({0.8, 0.1, 0.1}), material({0.8, 0.7, 0.1}), material({0.1, 0.7, 0.1}),
                       material({0.1, 0.2, 0.8})};
    scene.lights = {{PointLight{{10, 20, 30}}, Color(0.6)}, {PointLight{{-20, 5, -30}}, Color(0.6)}};
    return scene;
}

}  // namespace

Scene contact_sheet(std::uint64_t seed) {
    Draw draw(seed);
    Scene scene = lit_scene();
    const std::size_t columns = std::size(all_sides) * placements.size();
    scene.image = {cell_pixels * static_cast<int>(columns), cell_pixels * static_cast<int>(kinds.size())};
    scene.camera = {
        .position = {0, 0, 100}, .target = {0, 0, 0}, .projection = Orthographic{cell * double(kinds.size())}};
    for (std::size_t row = 0; row < kinds.size(); ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const Vec3d middle{cell * (double(column) - 0.5 * double(columns - 1)),
                               cell * (0.5 * double(kinds.size() - 1) - double(row)), 0};
            const auto& placement = placements[column % placements.size()];
            const Sides sides = all_sides[column / placements.size()];
            scene.objects.push_back(object_at(middle, kinds[row], placement, sides, draw));
        }
    }
    return scene;
}

Scene room_of_planes(std::uint64_t seed) {
    Draw draw(seed);
    Scene scene = lit_scene();
    scene.image = {2 * cell_pixels, 2 * cell_pixels};
    scene.camera = {.position = {0, 0, 1}, .target = {0, 0, 0}, .projection = Perspective{100}};
    scene.lights = {{PointLight{{0.5, 1, 2}}, Color(0.6)}, {PointLight{{-1, -0.5, -2}}, Color(0.6)}};
    for (const auto& placement : placements) {
        for (const Sides sides : all_sides) {
            const Vec3d normal = unit(draw);
            const Plane plane{convert<float>(-draw.number(5, 9) * normal), convert<float>(normal)};
            scene.objects.push_back(object(plane, placement(draw).rounded(), sides, draw));
        }
    }
    return scene;
}

Scene from_behind(Scene scene) {
    scene.camera.position = 2. * scene.camera.target - scene.camera.position;
    return scene;
}
