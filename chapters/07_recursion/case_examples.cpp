#include "case_examples.h"

#include "raylab/report/case_drawings.h"
#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace raylab::recursion {

namespace {

using namespace plane_ink;

std::string in_words(const RefractionQuery& query) {
    const auto& [d, n, before, behind] = query;
    return fmt::format("direction [{}, {}, {}], normal [{}, {}, {}], from index {} to {}", d.x, d.y, d.z, n.x, n.y, n.z,
                       before, behind);
}

PlanePoint times(double length, PlanePoint direction) { return {length * direction.x, length * direction.y}; }

}  // namespace

CaseExample example_at_critical_angle(const RefractionQuery& query, const std::optional<Vec3d>& truth,
                                      const std::optional<Vec3d>& answer) {
    const Vec3d d = glm::normalize(convert<double>(query.direction)), n = glm::normalize(convert<double>(query.normal));
    const double c = -dot(d, n);
    const CasePlane plane{{0, 0, 0}, glm::normalize(d + c * n), -n};
    const PlanePoint arriving = plane.at(d), mirrored{arriving.x, -arriving.y};
    const auto leaving = [&](const std::optional<Vec3d>& direction) {
        return times(1.8, direction ? plane.at(*direction) : mirrored);
    };
    PlaneSketch sketch;
    sketch.rectangle({-2.1, -1.7}, {2.1, 0}, filled(pale_blue));
    sketch.line({-2.1, 0}, {2.1, 0}, stroke(blue, 3));
    sketch.line({0, -1.5}, {0, 0.6}, stroke(grey, 1.5, dashed));
    sketch.arrow(times(-1.8, arriving), {0, 0}, stroke(orange));
    sketch.arrow({0, 0}, leaving(truth), stroke(green));
    sketch.arrow({0, 0}, leaving(answer), stroke(vermilion));
    auto drawing = case_drawing_around({{-2, -1.6}, {2, 0.6}});
    drawing.marks = sketch.marks();
    const double critical = std::asin(double{query.ior_behind} / double{query.ior_before});
    const double beyond = std::atan2(glm::length(d + c * n), c) - critical;
    drawing.notes = {
        fmt::format("{:.1e} rad {} the critical angle,", std::abs(beyond), beyond < 0 ? "short of" : "beyond"),
        truth ? "so in truth (green) some light gets out." : "so in truth (green) all is reflected."};
    return {in_words(query), drawing};
}

CaseExample example_through_slab(const RefractionQuery& query, const Vec3d& inside,
                                 const std::optional<Vec3d>& answer) {
    constexpr double steeper = 1000;  // outside, where a slope could not be seen
    const auto outside = [](const Vec3d& d) { return PlanePoint{1.6, 1.6 * steeper * d.y / d.x}; };
    const Vec3d before = convert<double>(query.direction);
    const Vec3d behind = answer.value_or(Vec3d{inside.x, -inside.y, inside.z});
    const PlanePoint out{-inside.x / inside.y, -1};
    const auto from_there = [&](PlanePoint way) { return PlanePoint{out.x + way.x, out.y + way.y}; };
    PlaneSketch sketch;
    sketch.rectangle({-2, -1}, {3, 0}, filled(pale_blue));
    for (const double y : {-1.0, 0.0}) sketch.line({-2, y}, {3, y}, stroke(blue, 3));
    sketch.arrow(times(-1, outside(before)), {0, 0}, stroke(orange));
    sketch.arrow({0, 0}, out, stroke(orange));
    sketch.arrow(out, from_there(outside(before)), stroke(green));
    sketch.arrow(out, from_there(answer ? outside(behind) : PlanePoint{0.8, 0.9}), stroke(vermilion));
    auto drawing = case_drawing_around({{-1.7, 0.7}, {2.7, -2}});
    drawing.marks = sketch.marks();
    drawing.notes = {"In truth (green) it leaves as it came.", "Slopes outside are drawn 1000-fold."};
    return {in_words(query), drawing};
}

}  // namespace raylab::recursion
