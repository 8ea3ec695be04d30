#include "raylab/report/structure/wrong_hit.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/geometry/quadric.h"
#include "raylab/report/case_drawings.h"
#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

// What is hit, as a plane cuts it. Absent where that is nothing that this drawing knows.
std::optional<PlaneFigure> cut_through(const Scene& scene, const Primitive& primitive, const CasePlane& plane) {
    if (primitive.object >= scene.objects.size()) return std::nullopt;  // of an instance
    const Shape& shape = scene.objects[primitive.object].shape;
    if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape))
        return plane.section(in<double>((*mesh)->triangle(primitive.part)));
    if (const auto* triangle = std::get_if<Triangle>(&shape)) return plane.section(in<double>(*triangle));
    if (const auto* sphere = std::get_if<Sphere>(&shape)) {
        const auto [center, radius] = in<double>(*sphere);
        const double off = dot(center - plane.origin, cross(plane.right, plane.up));
        return PlaneCircle{plane.at(center), std::sqrt(std::max(0.0, radius * radius - off * off))};
    }
    return std::nullopt;
}

std::vector<PlanePoint> ends_of(const PlaneFigure& figure) {
    if (const auto* polygon = std::get_if<PlanePolygon>(&figure)) return polygon->corners;
    const auto& [center, radius] = std::get<PlaneCircle>(figure);
    return {{center.x - radius, center.y - radius}, {center.x + radius, center.y + radius}};
}

std::string in_words(const std::optional<Hit>& hit, RayQuestion question) {
    if (!hit) return question == RayQuestion::any ? "nothing in the way" : "no hit";
    return question == RayQuestion::any ? "something in the way" : fmt::format("a hit at t = {:.4g}", hit->t);
}

}  // namespace

CaseExample wrong_hit(const Ray& ray, const Scene& scene, RayQuestion question, const std::optional<Hit>& given) {
    Traversal traversal;
    const auto truth = make_accelerator("list", scene)->closest(ray, traversal);
    const RayOf<double> way = in<double>(ray);
    const double unit = glm::length(way.direction);
    // Any plane through the ray shows where it hits; this one is not along a face of a scene that follows the axes.
    const CasePlane plane = plane_along(way, {0.3, 0.8, 0.5});
    std::vector<PlanePoint> points;
    PlaneSketch sketch;
    const auto show = [&](const Hit& hit, const std::string& color) {
        if (const auto figure = cut_through(scene, hit.primitive, plane)) {
            sketch.add(*figure, plane_ink::stroke(plane_ink::blue));
            std::ranges::copy(ends_of(*figure), std::back_inserter(points));
        }
        const PlanePoint at{unit * hit.t, 0};
        sketch.dot(at, 5, color);
        points.push_back(at);
    };
    if (truth) show(*truth, plane_ink::green);
    if (given && question == RayQuestion::nearest) show(*given, plane_ink::vermilion);
    if (points.empty()) points = {{0, 0}, {unit, 0}};
    const auto [first, last] = std::ranges::minmax(points, {}, &PlanePoint::x);
    const double around = 0.2 * std::max(last.x - first.x, 0.05 * std::abs(last.x));
    const PlanePoint begin{std::max(0.0, first.x - around), 0}, end{last.x + around, 0};
    points.insert(points.end(), {begin, end});
    sketch.arrow(begin, end, plane_ink::stroke(plane_ink::orange, 2));
    auto drawing = case_drawing_around(points);
    drawing.marks = sketch.marks();
    drawing.notes = {"In truth: " + in_words(truth, question) + (truth ? " (green)." : "."),
                     "The answer: " + in_words(given, question) + "."};
    return {in_words(ray), drawing};
}

}  // namespace raylab
