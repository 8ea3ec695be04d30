#include "raylab/scene/pov/area_light.h"

#include "raylab/geometry/local_frame.h"
#include "raylab/geometry/rectangle.h"
#include "raylab/scene/pov/light.h"
#include "raylab/scene/pov/words.h"
#include "raylab/scene/render_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab::pov {

namespace {

// A light as POV-Ray has it: points of a parallelogram around its middle, or of the ellipse in it. `normal` is zero
// where light leaves in all directions alike.
struct Grid {
    Vec3d middle, first, second, normal;
    double area;  // that is seen: m^2
    const char* words;
};

struct GridOf {
    const Affine& placement;

    Vec3d placed(const Vec3f& point) const { return transform_point(placement, convert<double>(point)); }
    Vec3d turned(const Vec3d& vector) const { return transform_vector(placement, vector); }

    std::optional<Grid> operator()(const Polygon& polygon) const {
        std::vector<Vec3d> corners;
        for (const Vec3f& vertex : polygon.vertices) corners.push_back(placed(vertex));
        if (!is_rectangle(corners)) return std::nullopt;
        const Vec3d first = corners[1] - corners[0], second = corners[3] - corners[0], across = cross(first, second);
        return Grid{0.5 * (corners[0] + corners[2]), first, second, across, glm::length(across), ""};
    }
    std::optional<Grid> operator()(const Disk& disk) const {
        const LocalFrame frame = frame_around(glm::normalize(convert<double>(disk.normal)));
        const Vec3d first = turned(2.0 * disk.radius * frame.x), second = turned(2.0 * disk.radius * frame.y);
        const Vec3d across = cross(first, second);
        return Grid{placed(disk.center), first, second, across, std::numbers::pi / 4 * glm::length(across),
                    " circular"};
    }
    std::optional<Grid> operator()(const Sphere& sphere) const {  // a disk that turns to each point it lights
        const double radius = sphere.radius * glm::length(turned({1, 0, 0}));
        return Grid{placed(sphere.center),
                    {2 * radius, 0, 0},
                    {0, 2 * radius, 0},
                    {0, 0, 0},
                    std::numbers::pi * radius * radius,
                    " circular orient"};
    }
    template <class Shape>
    std::optional<Grid> operator()(const Shape&) const {
        return std::nullopt;
    }
};

// A side of radiance L and area A is a spot whose intensity is L A / pi times the cosine.
std::string side(const Grid& grid, const Color& radiance, const Vec3d& normal, int per_side) {
    if (radiance == Color(0)) return "";
    std::string words;
    if (normal != Vec3d(0))
        words = " spotlight radius 90 falloff 90 tightness 1 point_at " + vector(grid.middle + glm::normalize(normal));
    // POV-Ray's points stand at the cells' corners, and are moved by half a cell to either side.
    const double inside = 1 - 1.0 / per_side;
    words += fmt::format(" area_light {}, {}, {}, {} jitter{} area_illumination on", vector(inside * grid.first),
                         vector(inside * grid.second), per_side, per_side, grid.words);
    return light_source(grid.middle, grid.area / std::numbers::pi * radiance, words, {0, 0, 1}, 1);
}

}  // namespace

bool is_light(const Object& object, const Scene& scene) {
    const auto emits = [&](std::size_t material, Sides hidden) {
        return object.sides != hidden && scene.materials[material].emission != Color(0);
    };
    return chosen_model(scene) != RenderModel::whitted &&
           (emits(object.front, Sides::back) || emits(object.back, Sides::front));
}

bool says_area_light(const Object& object) { return std::visit(GridOf{object.placement}, object.shape).has_value(); }

std::string area_light(const Object& object, const Scene& scene, int points) {
    if (!is_light(object, scene)) return "";
    const auto grid = std::visit(GridOf{object.placement}, object.shape);
    if (!grid) return "";
    const int per_side = std::max(2, static_cast<int>(std::lround(std::sqrt(points))));
    const Color front = object.sides == Sides::back ? Color(0) : scene.materials[object.front].emission;
    const Color back = object.sides == Sides::front ? Color(0) : scene.materials[object.back].emission;
    if (grid->normal == Vec3d(0)) return side(*grid, front, grid->normal, per_side);  // a sphere's inside is not seen
    return side(*grid, front, grid->normal, per_side) + side(*grid, back, -grid->normal, per_side);
}

}  // namespace raylab::pov
