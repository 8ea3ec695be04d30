#include "space_drawings.h"

#include "raylab/geometry/degree.h"
#include "raylab/report/plane/plane_angle.h"
#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

namespace raylab::transforms {

namespace {

using namespace plane_ink;

// Angles are in degrees, counter-clockwise from the right.

// A map of the plane: the columns of its matrix, and the translation.
struct Map {
    PlanePoint x, y, translation;

    PlanePoint vector(PlanePoint v) const { return {x.x * v.x + y.x * v.y, x.y * v.x + y.y * v.y}; }
    PlanePoint point(PlanePoint p) const {
        const PlanePoint v = vector(p);
        return {v.x + translation.x, v.y + translation.y};
    }
    double determinant() const { return x.x * y.y - x.y * y.x; }
    PlanePoint vector_back(PlanePoint v) const {
        return {(y.y * v.x - y.x * v.y) / determinant(), (x.x * v.y - x.y * v.x) / determinant()};
    }
    PlanePoint point_back(PlanePoint p) const { return vector_back({p.x - translation.x, p.y - translation.y}); }
    /// By the inverse transpose, not normalised.
    PlanePoint normal(PlanePoint n) const {
        return {(y.y * n.x - x.y * n.y) / determinant(), (x.x * n.y - y.x * n.x) / determinant()};
    }
};

PlanePoint along(PlanePoint from, PlanePoint way, double length) {
    const double scale = length / std::hypot(way.x, way.y);
    return {from.x + scale * way.x, from.y + scale * way.y};
}

PlanePoint at_angle(double degrees) { return {std::cos(degrees * degree), std::sin(degrees * degree)}; }

void add_circle(PlaneSketch& sketch, const Map& map) {
    std::vector<PlanePoint> corners;
    for (int i = 0; i < 360; i += 3) corners.push_back(map.point(at_angle(i)));
    sketch.polygon(corners, {.line = blue, .fill = pale_blue, .width = 2.5});
}

void add_title(PlaneSketch& sketch, PlanePoint at, const std::string& words) {
    sketch.words(at, words, {.anchor = Anchor::center, .color = black, .height = 16});
}

struct PlaneRay {
    PlanePoint origin, direction;

    PlanePoint at(double t) const { return {origin.x + t * direction.x, origin.y + t * direction.y}; }
};

// The smaller t at which the ray crosses the unit circle.
double hit_on_circle(const PlaneRay& ray) {
    const auto [o, d] = ray;
    const double a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y, c = o.x * o.x + o.y * o.y - 1;
    return (-b - std::sqrt(b * b - a * c)) / a;
}

// The ray with marks at whole t, and its hit.
void add_ray(PlaneSketch& sketch, const PlaneRay& ray, double hit, const std::string& prime) {
    sketch.arrow(ray.at(0), ray.at(2.75), {.line = vermilion, .width = 2});
    sketch.arrow(ray.at(0), ray.at(1), {.line = vermilion, .width = 4});
    for (int t = 0; t <= 2; ++t) {
        sketch.dot(ray.at(t), 6, vermilion);
        sketch.words(ray.at(t), fmt::format("*t* = {}", t), {.aside = {2, -14}, .height = 13});
    }
    sketch.words(ray.at(0), "*O*" + prime,
                 {.aside = {-8, 28}, .anchor = Anchor::center, .color = vermilion, .height = 15});
    sketch.words(ray.at(0.5), "**d**" + prime,
                 {.aside = {-6, 26}, .anchor = Anchor::center, .color = vermilion, .height = 15});
    sketch.dot(ray.at(hit), 7.5);
    sketch.words(ray.at(hit), "hit", {.aside = {-12, 26}, .anchor = Anchor::right, .height = 14});
}

// A hit with its normal and the way to the light, and the angle between.
void add_lit_point(PlaneSketch& sketch, PlanePoint at, PlanePoint normal, PlanePoint light, const std::string& prime) {
    const PlanePoint tip = along(at, normal, 1.5);
    sketch.line(at, light, {.line = orange, .width = 2.5});
    sketch.arrow(at, tip, {.line = green, .width = 2.8});
    const auto arc = angle_arc(at, tip, light, 0.85, {.line = black, .width = 1.8});
    sketch.add({arc, beside_arc(arc, fmt::format("{:.0f}°", std::abs(arc.to - arc.from)), 24, 15)});
    sketch.dot(at, 6.5);
    sketch.words(tip, "**N**" + prime, {.aside = {18, -4}, .anchor = Anchor::center, .color = green, .height = 15});
    sketch.dot(light, 10, orange);
    sketch.words(light, "light", {.aside = {0, -18}, .anchor = Anchor::center, .height = 14});
}

}  // namespace

PlaneDrawing draw_two_spaces() {
    const Map map{{1.1, 0}, {0.75, 0.7}, {0.55, 0.25}};
    constexpr double apart = 8.4;
    const PlaneRay world{{-2.3, 1.5}, {1.25, -0.56}};
    PlaneRay object{map.point_back(world.origin), map.vector_back(world.direction)};
    const double hit = hit_on_circle(object);
    object.origin.x += apart;
    const Map stored{{1, 0}, {0, 1}, {apart, 0}};
    PlaneSketch sketch;
    add_circle(sketch, map);
    add_circle(sketch, stored);
    for (const Map& each : {map, stored})
        for (const PlanePoint axis : {PlanePoint{1, 0}, {0, 1}})
            sketch.arrow(each.point({0, 0}), each.point(axis), {.line = grey, .width = 1.8});
    add_ray(sketch, world, hit, "");
    add_ray(sketch, object, hit, "′");
    add_title(sketch, {0, -1.75}, "the world");
    add_title(sketch, {apart - 1, -1.75}, "object space");
    sketch.add(PlaneDrawing::Arc{{3.5, 0.2}, 0.9, 125, 55, {.line = black, .width = 2}, PlaneDrawing::Arc::Tip::arrow});
    sketch.words({3.5, 1.15}, "*M*^{–1}", {.aside = {0, -10}, .anchor = Anchor::center, .height = 15});
    sketch.add(
        PlaneDrawing::Arc{{3.5, 0.0}, 0.9, -55, -125, {.line = black, .width = 2}, PlaneDrawing::Arc::Tip::arrow});
    sketch.words({3.5, -0.95}, "*M*", {.aside = {0, 24}, .anchor = Anchor::center, .height = 15});
    return sketch.drawing({-2.9, -1.9}, {9.7, 2.9}, 960, 385);
}

PlaneDrawing draw_normal_scale() {
    constexpr double apart = 4.6, angle = 50;
    const Map stored{{1, 0}, {0, 1}, {0, 0}}, map{{1.9, 0}, {0, 0.65}, {apart, 0}};
    const PlanePoint normal = at_angle(angle), tangent = at_angle(angle - 90), point = stored.point(normal);
    PlaneSketch sketch;
    add_circle(sketch, stored);
    const auto arrow = [&](PlanePoint from, PlanePoint to, const char* color, const std::string& words, Point2 aside,
                           Dash dash) {
        sketch.arrow(from, to, {.line = color, .width = 2.8, .dash = dash});
        sketch.words(to, words, {.aside = aside, .anchor = Anchor::center, .color = color, .height = 15});
    };
    const auto upright = [&](PlanePoint at, PlanePoint one, PlanePoint other) {
        sketch.add(right_angle(at, one, other, 0.13, {.line = black, .width = 1.5}));
    };
    const PlanePoint v = along(point, tangent, 0.9), n = along(point, normal, 0.9);
    upright(point, v, n);
    arrow(point, v, black, "**v**", {18, 10}, solid);
    arrow(point, n, green, "**n**", {16, -4}, solid);
    sketch.dot(point, 6);

    add_circle(sketch, map);
    const PlanePoint placed = map.point(normal);
    const PlanePoint mv = along(placed, map.vector(tangent), 1.3), mn = along(placed, map.vector(normal), 1.2),
                     right = along(placed, map.normal(normal), 1.2);
    upright(placed, mv, right);
    arrow(placed, mv, black, "*M* **v**", {34, 8}, solid);
    arrow(placed, mn, vermilion, "*M* **n** leans", {66, -2}, dashed);
    arrow(placed, right, green, "*M*^{–T} **n**", {0, -14}, solid);
    sketch.dot(placed, 6);
    add_title(sketch, {0, -1.55}, "object space");
    add_title(sketch, {apart, -1.55}, "the world");
    return sketch.drawing({-1.5, -1.7}, {8.2, 2.1}, 960, 400);
}

PlaneDrawing draw_shade_in_world() {
    constexpr double apart = 6.4, angle = 50;
    const Map map{{2.0, 0}, {0, 0.75}, {0, 0}}, stored{{1, 0}, {0, 1}, {apart, 0}};
    const PlanePoint normal = at_angle(angle), light{1.2, 2.6};
    PlanePoint carried = map.point_back(light);
    carried.x += apart;
    PlaneSketch sketch;
    add_circle(sketch, map);
    add_circle(sketch, stored);
    add_lit_point(sketch, map.point(normal), map.normal(normal), light, "");
    add_lit_point(sketch, stored.point(normal), normal, carried, "′");
    add_title(sketch, {0, -1.6}, "the world: the light is here");
    add_title(sketch, {apart, -1.6}, "object space: other angles");
    return sketch.drawing({-2.3, -1.8}, {10.0, 4.2}, 960, 460);
}

}  // namespace raylab::transforms
