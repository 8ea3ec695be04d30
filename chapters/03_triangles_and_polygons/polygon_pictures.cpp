#include "polygon_pictures.h"

#include "raylab/experiment/ray_polygon/even_odd.h"
#include "raylab/experiment/ray_polygon/fan.h"
#include "raylab/experiment/ray_polygon/half_planes.h"
#include "raylab/geometry/dominant_axis.h"
#include "raylab/image/draw.h"
#include "raylab/scene/picture_point.h"
#include "raylab/tracer/picture/eye_picture.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace raylab {

namespace {

constexpr double wall = -1.4;  // the three walls are at x, y, z = wall
constexpr double infinity = std::numeric_limits<double>::infinity();

Color color_of(const Pixel& pixel) { return {pixel.r, pixel.g, pixel.b}; }

/// A star of five points in the plane through the world's origin with this normal.
Polygon star(const Vec3d& normal) {
    const Vec3d x = glm::normalize(cross({0, 1, 0}, normal)), y = cross(glm::normalize(normal), x);
    Polygon polygon;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::numbers::pi * (0.5 + i / 5.0), radius = i % 2 == 0 ? 1.15 : 0.45;
        polygon.vertices.push_back(convert<float>(radius * (std::cos(angle) * x + std::sin(angle) * y)));
    }
    return polygon;
}

const Vec3d tilted{0.45, 0.5, 1};

std::optional<double> wall_hit(const RayOf<double>& ray, int axis) {
    const double t = (wall - ray.origin[axis]) / ray.direction[axis];
    if (!contains(ray.range, t)) return std::nullopt;
    const Vec3d point = ray.origin + t * ray.direction;
    const auto [first, second] = other_axes(axis);
    const auto is_on_wall = [](double x) { return x >= wall && x <= 1.4; };
    return is_on_wall(point[first]) && is_on_wall(point[second]) ? std::optional(t) : std::nullopt;
}

/// Whether a point of the wall is in the star's projection along the axis.
bool is_in_projection(const Vec3d& point, int axis, const PolygonIn<double>& polygon) {
    RayOf<double> along{point, {0, 0, 0}, {0, infinity}};
    along.direction[axis] = 1;
    return even_odd(along, polygon).has_value();
}

Color seen(const RayOf<double>& ray, const PolygonIn<double>& polygon, int dominant) {
    if (even_odd(ray, polygon)) return color_of(ink::orange);
    for (const int axis : {0, 1, 2}) {
        const auto t = wall_hit(ray, axis);
        if (!t) continue;
        const Vec3d point = ray.origin + *t * ray.direction;
        if (!is_in_projection(point, axis, polygon)) return Color(axis == 1 ? 0.75 : 0.85);
        return axis == dominant ? color_of(ink::blue) : Color(0.45);
    }
    return Color(1);
}

/// Labels each wall with the area of the projection along its axis, which is that component of the normal.
void label_walls(Image& image, const CameraFrame& frame, const Vec3d& normal) {
    const double area = glm::length(normal) / 2;
    const std::array<const char*, 3> names = {"x", "y", "z"};
    for (const int axis : {0, 1, 2}) {
        Vec3d at(axis == 1 ? Vec3d{0.5, wall, 1.75} : Vec3d{0.7, 1.5, 0.7});  // beside each wall
        at[axis] = wall;
        const auto place = picture_point(frame, at);
        if (!place) continue;
        const double share = std::abs(normal[axis]) / 2 / area;
        draw_text(image, *place, 12,
                  fmt::format("without {}: {:.0f} % of the area", names[static_cast<std::size_t>(axis)], 100 * share),
                  ink::black, Anchor::center);
    }
}

}  // namespace

Image projection_picture(ImageSize size, int threads) {
    const PolygonIn<double> polygon(star(tilted));
    const CameraFrame frame =
        camera_frame({.position = {5, 3.6, 7}, .target = {-0.15, -0.2, -0.1}, .projection = Perspective{29}}, size);
    const int dominant = dominant_axis(polygon.normal);
    Image image = eye_picture(frame, {.samples = {SamplePattern::jittered, 3}, .threads = threads},
                              [&](const Ray& ray) { return seen(in<double>(ray), polygon, dominant); });
    label_walls(image, frame, polygon.normal);
    return image;
}

Polygon flat_star() { return star({0, 0, 1}); }

Image star_picture(StarMethod method, ImageSize size, int threads) {
    const PolygonIn<double> polygon(flat_star());
    const CameraFrame frame =
        camera_frame({.position = {0, 0, 4}, .target = {0, 0, 0}, .projection = Orthographic{2.6}}, size);
    Image image = eye_picture(frame, {.threads = threads}, [&](const Ray& narrow) {
        const auto ray = in<double>(narrow);
        const bool truth = even_odd(ray, polygon).has_value();
        const bool says = method == StarMethod::even_odd      ? truth
                          : method == StarMethod::half_planes ? half_planes(ray, polygon).has_value()
                                                              : fan(ray, polygon).has_value();
        if (says && truth) return color_of(ink::orange);
        if (!says && !truth) return Color(1);
        return says ? Color(0) : color_of(ink::sky_blue);  // for a false hit, and for a miss
    });
    const Point2 below{0.5 * size.width, 0.97 * size.height};
    if (method == StarMethod::half_planes) draw_text(image, below, 13, "blue: missed", ink::black, Anchor::center);
    if (method == StarMethod::fan) draw_text(image, below, 13, "black: hit, but outside", ink::black, Anchor::center);
    return image;
}

}  // namespace raylab
