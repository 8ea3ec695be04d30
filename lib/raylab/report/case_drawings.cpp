#include "raylab/report/case_drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr int case_width = 300, case_height = 220;
const PlaneStyle shape{.line = "#0072b2", .fill = "#e3eef6", .width = 2};
constexpr const char* ray_color = "#d55e00";

// Every float reads back as itself.
std::string in_words(const Vec3f& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

std::string in_words(TrueAnswer truth) {
    return truth == TrueAnswer::hit ? "In truth it hits." : "In truth it misses.";
}

// The directions across a ray.
CasePlane across(const RayOf<double>& ray) {
    const Vec3d along = glm::normalize(ray.direction);
    const Vec3d aside = glm::normalize(cross(along, std::abs(along.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    return {ray.origin, aside, cross(aside, along)};
}

PlaneDrawing::Dot ray_as_dot() { return {{0, 0}, 4, ray_color}; }

// The eight corners are numbered by bits: 1 is the far end along x, 2 along y, 4 along z.
Vec3d corner_of(const Box& box, unsigned corner) {
    const auto at = [&](int axis) { return double{corner >> axis & 1 ? box.max[axis] : box.min[axis]}; };
    return {at(0), at(1), at(2)};
}

}  // namespace

std::string in_words(const Ray& ray) {
    return "ray from " + in_words(ray.origin) + " along " + in_words(ray.direction);
}

std::optional<PlanePolygon> CasePlane::section(const TriangleOf<double>& triangle) const {
    const Vec3d normal = cross(right, up);
    const Vec3d corners[] = {triangle.a, triangle.b, triangle.c};
    PlanePolygon line;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d &from = corners[i], &to = corners[(i + 1) % 3];
        const double a = dot(from - origin, normal), b = dot(to - origin, normal);
        if ((a < 0) != (b < 0)) line.corners.push_back(at(from + a / (a - b) * (to - from)));
    }
    return line.corners.size() == 2 ? std::optional(line) : std::nullopt;
}

CasePlane plane_along(const RayOf<double>& ray, const Vec3d& beside) {
    const Vec3d along = glm::normalize(ray.direction), other = beside - dot(beside, along) * along;
    return {ray.origin, along, glm::length(other) > 0 ? glm::normalize(other) : across(ray).right};
}

PlaneDrawing case_drawing_around(const std::vector<PlanePoint>& points) {
    const auto [x0, x1] = std::ranges::minmax(points, {}, &PlanePoint::x);
    const auto [y0, y1] = std::ranges::minmax(points, {}, &PlanePoint::y);
    const double margin = 0.08 * std::max(x1.x - x0.x, y1.y - y0.y);
    return {.low = {x0.x - margin, y0.y - margin},
            .high = {x1.x + margin, y1.y + margin},
            .width = case_width,
            .height = case_height};
}

CaseExample example_of(const Ray& ray, const Sphere& sphere, TrueAnswer truth) {
    const Vec3d along = glm::normalize(convert<double>(ray.direction));
    const Vec3d from_center = convert<double>(ray.origin) - convert<double>(sphere.center);
    const double radius = sphere.radius, start = dot(from_center, along) / radius;
    const double distance = glm::length(from_center - dot(from_center, along) * along) / radius;
    const double left = std::max(-1.7, start);  // a ray from afar enters at the drawing's edge
    PlaneDrawing drawing{.low = {-1.7, -1.2}, .high = {1.7, 1.25}, .width = case_width, .height = case_height};
    drawing.marks.push_back(PlaneDrawing::Figure{PlaneCircle{{0, 0}, 1}, shape});
    drawing.marks.push_back(PlaneDrawing::Dot{{0, 0}, 2, "#0072b2"});
    drawing.marks.push_back(
        PlaneDrawing::Arrow{{left, distance}, {std::max(1.65, left + 0.5), distance}, {.line = ray_color, .width = 2}});
    if (start > -1.7) drawing.marks.push_back(PlaneDrawing::Dot{{start, distance}, 4, ray_color});
    drawing.notes = {fmt::format("It passes the centre at {:.7g} radii.", distance), in_words(truth)};
    return {in_words(ray) + fmt::format(", sphere about {} of radius {}", in_words(sphere.center), sphere.radius),
            drawing};
}

PlaneDrawing seen_along(const RayOf<double>& ray, const std::vector<TriangleOf<double>>& triangles,
                        const std::string& truth) {
    const CasePlane view = across(ray);
    std::vector<PlanePoint> points = {{0, 0}};
    std::vector<PlaneDrawing::Mark> marks;
    for (const auto& [a, b, c] : triangles) {
        const std::vector corners{view.at(a), view.at(b), view.at(c)};
        points.insert(points.end(), corners.begin(), corners.end());
        marks.push_back(PlaneDrawing::Figure{PlanePolygon{corners}, shape});
    }
    auto drawing = case_drawing_around(points);
    drawing.marks = marks;
    drawing.marks.push_back(ray_as_dot());
    drawing.notes = {"Seen along the ray, which is the dot.", truth};
    return drawing;
}

CaseExample example_of(const Ray& ray, const Triangle& triangle, TrueAnswer truth) {
    return {in_words(ray) + ", triangle " + in_words(triangle.a) + ", " + in_words(triangle.b) + ", " +
                in_words(triangle.c),
            seen_along(in<double>(ray), {in<double>(triangle)}, in_words(truth))};
}

CaseExample example_of(const Ray& ray, const Box& box, TrueAnswer truth) {
    const CasePlane view = across(in<double>(ray));
    std::vector<PlanePoint> points = {{0, 0}};
    std::vector<PlaneDrawing::Mark> marks;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const PlanePoint from = view.at(corner_of(box, corner));
        points.push_back(from);
        for (const unsigned bit : {1u, 2u, 4u})
            if ((corner & bit) == 0)
                marks.push_back(PlaneDrawing::Path{{from, view.at(corner_of(box, corner | bit))},
                                                   {.line = shape.line, .width = 2}});
    }
    auto drawing = case_drawing_around(points);
    drawing.marks = marks;
    drawing.marks.push_back(ray_as_dot());
    drawing.notes = {"Seen along the ray, which is the dot.", in_words(truth)};
    return {in_words(ray) + ", box from " + in_words(box.min) + " to " + in_words(box.max), drawing};
}

}  // namespace raylab
