#include "drawings.h"

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"
#include "raylab/report/plane/plane_angle.h"
#include "raylab/report/plane/plane_hull.h"
#include "raylab/report/plane/plane_sketch.h"
#include "raylab/sampling/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::volumes {

namespace {

using namespace plane_ink;

constexpr PlaneStyle bold_line{.width = 2.5};

// Light from above: parallel rays down to the ground.
void add_rays(PlaneSketch& sketch, const std::vector<double>& places, double top, double ground) {
    for (const double x : places) sketch.arrow({x, top}, {x, ground}, {.line = orange, .width = 1.5});
}

}  // namespace

PlaneDrawing draw_cauchy() {
    constexpr double ground = 0, top = 3.3;
    PlaneSketch sketch;
    sketch.line({-0.3, ground}, {8.6, ground}, {.line = grey, .width = 1.5});
    // A patch, its normal, and its shadow.
    const PlanePoint left{0.4, 1.1}, right{2.6, 2.1}, middle{1.5, 1.6};
    const double length = std::hypot(right.x - left.x, right.y - left.y);
    const PlanePoint normal{middle.x - 1.3 * (right.y - left.y) / length, middle.y + 1.3 * (right.x - left.x) / length};
    add_rays(sketch, {left.x, right.x}, top, ground);
    sketch.line(left, right, {.line = blue, .width = 4});
    sketch.line({left.x, ground}, {right.x, ground}, {.line = vermilion, .width = 6});
    sketch.line(middle, {middle.x, top}, {.line = orange, .width = 1.5, .dash = dashed});
    sketch.arrow(middle, normal, {.line = blue, .width = 2});
    const PlaneDrawing::Arc angle = angle_arc(middle, {middle.x, top}, normal, 0.85, {.width = 1.5});
    sketch.add({angle, beside_arc(angle, "*θ*", 12, 13)});
    sketch.words(right, "d*S*", {.aside = {8, 0}, .color = blue, .height = 13});
    sketch.words(normal, "**N**", {.aside = {-10, -4}, .anchor = Anchor::right, .color = blue, .height = 13});
    sketch.words({middle.x, ground}, "d*S* |cos *θ*|",
                 {.aside = {0, 26}, .anchor = Anchor::center, .color = vermilion, .height = 13});
    // A convex body: every ray that meets it goes in and comes out.
    const std::vector<PlanePoint> body{{5, 1.5},   {5.5, 0.7}, {6.9, 0.6}, {7.9, 1.3},
                                       {7.6, 2.3}, {6.2, 2.7}, {5.2, 2.3}};
    add_rays(sketch, {5, 5.6, 6.2, 6.8, 7.4, 7.9}, top, ground);
    sketch.polygon(body, {.line = blue, .fill = pale_blue, .width = 2.5});
    for (const double x : {5.6, 6.2, 6.8, 7.4}) {
        for (std::size_t i = 0; i < body.size(); ++i) {
            const PlanePoint a = body[i], b = body[(i + 1) % body.size()];
            if ((a.x < x) == (b.x < x)) continue;
            sketch.dot({x, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)}, 4.5);
        }
    }
    sketch.line({5, ground}, {7.9, ground}, {.line = vermilion, .width = 6});
    sketch.words({6.45, ground}, "its shadow *A*, covered twice",
                 {.aside = {0, 26}, .anchor = Anchor::center, .color = vermilion, .height = 13});
    sketch.words({7.75, 2.2}, "surface *S*", {.aside = {14, -8}, .color = blue, .height = 13});
    return {.low = {-0.3, -0.45}, .high = {9.2, 3.4}, .width = 960, .height = 400, .marks = sketch.marks()};
}

namespace {

// A unit cube seen along a direction: its corners in the plane.
std::vector<PlanePoint> cube_along(const Vec3d& direction) {
    const Vec3d right = glm::normalize(cross(direction, Vec3d{0, 0, 1})), up = cross(right, direction);
    std::vector<PlanePoint> corners;
    for (int i = 0; i < 8; ++i) {
        const Vec3d corner = Vec3d{i & 1 ? 1 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0} - Vec3d(0.5);
        corners.push_back({dot(corner, right), dot(corner, up)});
    }
    return corners;
}

// Of a cube whose edges lie along the axes: each face's shadow is the share of the direction along its normal.
double shadow_of_cube(const Vec3d& d) { return std::abs(d.x) + std::abs(d.y) + std::abs(d.z); }

}  // namespace

PlaneDrawing draw_shadows_of_cube() {
    constexpr int shown = 8, many = 100'000;
    PlaneSketch sketch;
    double sum = 0, sum_of_many = 0;
    for (int i = 0; i < many; ++i) {
        RandomSequence random(1, static_cast<std::uint64_t>(i));
        sum_of_many += shadow_of_cube(random.unit_vector());
    }
    for (int i = 0; i < shown; ++i) {
        RandomSequence random(1, static_cast<std::uint64_t>(i));
        const Vec3d direction = random.unit_vector();
        const PlanePoint middle{2.0 * (i % 4), -2.35 * (i / 4)};
        std::vector<PlanePoint> corners = cube_along(direction);
        for (PlanePoint& corner : corners) corner = {corner.x + middle.x, corner.y + middle.y};
        sketch.polygon(convex_hull(corners), {.line = blue, .fill = pale_blue, .width = 2});
        // The three edges that meet in the corner nearest to the eye.
        int nearest = 0;
        for (int axis = 0; axis < 3; ++axis) nearest |= direction[axis] < 0 ? 1 << axis : 0;
        for (const int axis : {1, 2, 4})
            sketch.line(corners[static_cast<std::size_t>(nearest)], corners[static_cast<std::size_t>(nearest ^ axis)],
                        {.line = blue, .width = 1.2});
        const double area = shadow_of_cube(direction);
        sum += area;
        sketch.words({middle.x, middle.y - 1.05}, fmt::format("{:.2f}", area),
                     {.anchor = Anchor::center, .height = 13});
    }
    sketch.words({3, -4.0},
                 fmt::format("mean of these {}: {:.2f};  of 100 000 directions: {:.3f};  *S* / 4 = 6 / 4 = 1.5", shown,
                             sum / shown, sum_of_many / many),
                 {.anchor = Anchor::center, .height = 13});
    return {.low = {-1, -4.1}, .high = {7, 1}, .width = 960, .height = 610, .marks = sketch.marks()};
}

namespace {

// The box about the ball of the chapter's scene, and rays from its camera.
const Box ball_box{{-2.52f, 0, -0.22f}, {-1.28f, 1.24f, 1.02f}};
const Vec3d eye{1.7, 2.6, 9.6};

Interval<double> span_in_slab(const Vec3d& direction, int axis) {
    const double a = (ball_box.min[axis] - eye[axis]) / direction[axis],
                 b = (ball_box.max[axis] - eye[axis]) / direction[axis];
    return {std::min(a, b), std::max(a, b)};
}

// From above, the way of the eye's rays to the right: as all go down z equally fast, t grows evenly to the right.
constexpr double fast = 9.2;
PlanePoint from_above(const Vec3d& p) { return {eye.z - p.z, p.x}; }
double place_of_t(double t) { return fast * t; }

struct ShownRay {
    const char *name, *color;
    Vec3d direction;
};
const std::array<ShownRay, 2> shown_rays{{{"a", blue, {-3.4, -2.2, -fast}}, {"b", vermilion, {-2.7, -2, -fast}}}};

// A ray's spans of t in the three slabs, one below the other, and where they overlap.
void add_spans(PlaneSketch& sketch, const ShownRay& ray, double top) {
    Interval<double> inside{0, 100};
    for (int axis = 0; axis < 3; ++axis) {
        const auto span = span_in_slab(ray.direction, axis);
        inside = {std::max(inside.min, span.min), std::min(inside.max, span.max)};
    }
    if (inside.min <= inside.max)
        sketch.rectangle({place_of_t(inside.min), top - 0.62 * 2 - 0.3}, {place_of_t(inside.max), top + 0.3},
                         {.line = black, .fill = "#b9d9ee", .width = 1.5});
    for (int axis = 0; axis < 3; ++axis) {
        const auto [enter, leave] = span_in_slab(ray.direction, axis);
        const double y = top - 0.62 * axis;
        sketch.rectangle({place_of_t(enter), y - 0.17}, {place_of_t(leave), y + 0.17}, {.line = ray.color, .width = 2});
        sketch.words({place_of_t(enter), y}, fmt::format("{:.3f}", enter),
                     {.aside = {-8, 5}, .anchor = Anchor::right, .height = 11});
        sketch.words({place_of_t(leave), y}, fmt::format("{:.3f}", leave), {.aside = {8, 5}, .height = 11});
        sketch.words({0, y}, fmt::format("ray {}, between the planes of *{}*", ray.name, "xyz"[axis]),
                     {.aside = {0, 5}, .color = ray.color});
    }
}

}  // namespace

PlaneDrawing draw_slabs() {
    const PlanePoint low = from_above({-2.52, 0, 1.02}), high = from_above({-1.28, 0, -0.22});
    constexpr double left = 0, right = 14.9, bottom = -3.3, top = 2.2;
    PlaneSketch sketch;
    sketch.rectangle({left, low.y}, {right, high.y}, {.line = "", .fill = pale_orange});
    sketch.rectangle({low.x, bottom}, {high.x, top}, {.line = "", .fill = pale_green});
    sketch.rectangle(low, high, {.line = "", .fill = "#ffffff"});
    for (const double y : {low.y, high.y}) sketch.line({left, y}, {right, y}, {.line = orange, .width = 1.5});
    for (const double x : {low.x, high.x}) sketch.line({x, bottom}, {x, top}, {.line = green, .width = 1.5});
    sketch.rectangle(low, high, bold_line);
    sketch.words({left, (low.y + high.y) / 2}, "between the planes of *x*", {.aside = {6, 5}, .halo = ""});
    sketch.words({high.x, top}, "between the planes of *z*", {.aside = {10, 16}, .halo = ""});
    sketch.words({low.x, low.y}, "the box", {.aside = {-4, 18}, .anchor = Anchor::right});
    for (const ShownRay& ray : shown_rays) {
        const Vec3d end = eye + ray.direction * 1.42;
        sketch.arrow(from_above(eye), from_above(end), {.line = ray.color, .width = 2.2});
        sketch.words(from_above(end), std::string("ray ") + ray.name, {.aside = {6, 5}, .color = ray.color});
    }
    const Vec3d entry = eye + shown_rays[0].direction * span_in_slab(shown_rays[0].direction, 2).min;
    sketch.dot(from_above(entry), 5);
    sketch.dot(from_above(eye), 5);
    sketch.words(from_above(eye), "eye", {.aside = {8, -12}});
    add_spans(sketch, shown_rays[0], -4.2);
    add_spans(sketch, shown_rays[1], -6.4);
    return {
        .low = {left - 0.1, -8.1}, .high = {right + 0.4, top}, .width = 960, .height = 680, .marks = sketch.marks()};
}

}  // namespace raylab::volumes
