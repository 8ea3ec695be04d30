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

std::string in_words(const Ray& ray) {
    return "ray from " + in_words(ray.origin) + " along " + in_words(ray.direction);
}

std::string in_words(TrueAnswer truth) {
    return truth == TrueAnswer::hit ? "In truth it hits." : "In truth it misses.";
}

}  // namespace

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

CaseExample example_of(const Ray& ray, const Triangle& triangle, TrueAnswer truth) {
    const Vec3d along = glm::normalize(convert<double>(ray.direction));
    const Vec3d aside = glm::normalize(cross(along, std::abs(along.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    const Vec3d above = cross(aside, along);
    std::vector<PlanePoint> corners;
    for (const auto& corner : {triangle.a, triangle.b, triangle.c}) {
        const Vec3d offset = convert<double>(corner) - convert<double>(ray.origin);
        corners.push_back({dot(offset, aside), dot(offset, above)});
    }
    auto points = corners;
    points.push_back({0, 0});
    const auto [x0, x1] = std::ranges::minmax(points, {}, &PlanePoint::x);
    const auto [y0, y1] = std::ranges::minmax(points, {}, &PlanePoint::y);
    PlaneDrawing drawing{.low = {x0.x, y0.y}, .high = {x1.x, y1.y}, .width = case_width, .height = case_height};
    drawing.marks.push_back(PlaneDrawing::Figure{PlanePolygon{corners}, shape});
    drawing.marks.push_back(PlaneDrawing::Dot{{0, 0}, 4, ray_color});
    drawing.notes = {"Seen along the ray, which is the dot.", in_words(truth)};
    return {in_words(ray) + ", triangle " + in_words(triangle.a) + ", " + in_words(triangle.b) + ", " +
                in_words(triangle.c),
            drawing};
}

}  // namespace raylab
