#include "drawings.h"

#include "bystander.h"
#include "light_paths.h"

#include "raylab/image/draw.h"
#include "raylab/tracer/shading/surface_point.h"

#include <array>
#include <optional>
#include <string>

namespace raylab::ray_generation {

namespace {

constexpr double picture_distance = 1.6;  // distance of the drawn picture rectangle from the eye, in metres

// A view of camera, scene and light.
Bystander overlooking(const Stage& stage) { return Bystander(stage, {10.2, 7.0, 9.4}, {0.2, 1.1, 2.2}, {640, 480}); }

// A point of the picture rectangle, (0, 0) its top left and (1, 1) its bottom right corner.
Vec3d on_rectangle(const CameraFrame& frame, double x, double y) {
    const auto ray = picture_ray(frame, x * frame.image.width, y * frame.image.height);
    if (frame.projection == CameraFrame::Projection::orthographic) return ray.origin;
    return ray.origin + picture_distance / dot(ray.direction, frame.forward) * ray.direction;
}

void draw_rectangle_of(Bystander& bystander, const CameraFrame& frame, int columns, int rows) {
    for (int i = 0; i <= columns; ++i)
        bystander.line(on_rectangle(frame, 1.0 * i / columns, 0), on_rectangle(frame, 1.0 * i / columns, 1),
                       i == 0 || i == columns ? 2 : 0.8, ink::white);
    for (int j = 0; j <= rows; ++j)
        bystander.line(on_rectangle(frame, 0, 1.0 * j / rows), on_rectangle(frame, 1, 1.0 * j / rows),
                       j == 0 || j == rows ? 2 : 0.8, ink::white);
}

// Where an eye ray ends: on a surface, or at some distance in the sky.
struct End {
    Vec3d position;
    bool on_surface;
};

End end_of(const Stage& stage, const Ray& ray) {
    Traversal traversal;
    const auto hit = stage.accelerator.closest(ray, traversal);
    if (!hit) return {convert<double>(ray.origin) + 9.0 * convert<double>(ray.direction), false};
    return {surface_point(stage.scene, ray, *hit).position, true};
}

Ray ray_at(const CameraFrame& frame, double x, double y) {
    return eye_ray(frame, x * frame.image.width, y * frame.image.height);
}

}  // namespace

Image draw_camera(const Stage& stage, const CameraFrame& frame) {
    Bystander bystander(stage, {6.2, 4.0, 8.6}, {0.5, 1.15, 3.5}, {1280, 760});
    constexpr int columns = 8, rows = 6;
    draw_rectangle_of(bystander, frame, columns, rows);
    for (const double x : {0.0, 1.0})
        for (const double y : {0.0, 1.0}) bystander.line(frame.eye, on_rectangle(frame, x, y), 0.8, ink::white);
    const double x = 2.5 / columns, y = 3.5 / rows;  // the center of pixel (2, 3)
    const End end = end_of(stage, ray_at(frame, x, y));
    bystander.line(frame.eye, end.position, 2.2, ink::yellow);
    bystander.dot(on_rectangle(frame, x, y), 3.5, ink::yellow);
    bystander.dot(end.position, 3.5, ink::yellow);
    bystander.arrow(frame.eye, frame.eye + 1.1 * frame.right, 3, ink::vermilion);
    bystander.arrow(frame.eye, frame.eye + 1.1 * frame.up, 3, ink::green);
    bystander.arrow(frame.eye, frame.eye + 1.1 * frame.forward, 3, ink::blue);
    bystander.dot(frame.eye, 4, ink::white);
    bystander.label(frame.eye, "eye", {-38, 26});
    bystander.label(frame.eye + 1.1 * frame.right, "right", {12, 12}, ink::vermilion);
    bystander.label(frame.eye + 1.1 * frame.up, "up", {14, 4}, ink::green);
    bystander.label(frame.eye + 1.1 * frame.forward, "forward", {-42, -14}, ink::blue);
    bystander.label(on_rectangle(frame, 0.5 / columns, 0.5 / rows), "pixel (0, 0)", {-30, -26});
    bystander.label(on_rectangle(frame, x, y), "pixel (2, 3)", {-40, 86});
    bystander.label(end.position, "hit", {10, -10});
    return bystander.picture();
}

Image draw_bundle(const Stage& stage, const CameraFrame& frame) {
    Bystander bystander = overlooking(stage);
    draw_rectangle_of(bystander, frame, 1, 1);
    constexpr int columns = 6, rows = 4;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const double x = (i + 0.5) / columns, y = (j + 0.5) / rows;
            const Ray ray = ray_at(frame, x, y);
            const End end = end_of(stage, ray);
            bystander.line(convert<double>(ray.origin), end.position, 1, ink::yellow);
            bystander.dot(on_rectangle(frame, x, y), 1.6, ink::white);
            if (end.on_surface) bystander.dot(end.position, 2.4, ink::yellow);
        }
    bystander.dot(frame.eye, 4, ink::white);
    return bystander.picture();
}

Image draw_light_paths(const Stage& stage, const CameraFrame& frame, std::uint64_t seed) {
    Bystander bystander = overlooking(stage);
    draw_rectangle_of(bystander, frame, 1, 1);
    constexpr std::uint64_t rays = 60;
    const std::array<Pixel, 3> by_segment{ink::yellow, ink::orange, ink::vermilion};
    for (std::uint64_t ray = 0; ray < rays; ++ray) {
        const auto stations = light_path(stage.scene, stage.accelerator, seed, ray, 3);
        for (std::size_t i = 1; i < stations.size(); ++i) {
            bystander.line(stations[i - 1], stations[i], i == 1 ? 0.8 : 1.4, by_segment[i - 1]);
            if (i + 1 < stations.size()) bystander.dot(stations[i], 1.6, by_segment[i - 1]);
        }
    }
    bystander.dot(frame.eye, 4, ink::white);
    bystander.label(frame.eye, "eye", {-14, 24});
    return bystander.picture();
}

Image draw_eye_paths(const Stage& stage, const CameraFrame& frame) {
    Bystander bystander = overlooking(stage);
    draw_rectangle_of(bystander, frame, 1, 1);
    constexpr int columns = 6, rows = 5;
    const Vec3d light = std::get<PointLight>(stage.scene.lights.at(0).kind).position;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const Ray ray = ray_at(frame, (i + 0.5) / columns, (j + 0.5) / rows);
            const End end = end_of(stage, ray);
            if (!end.on_surface) continue;
            bystander.line(frame.eye, end.position, 1.2, ink::sky_blue);
            bystander.line(end.position, light, 0.8, ink::yellow);
            bystander.dot(end.position, 1.6, ink::sky_blue);
        }
    bystander.dot(frame.eye, 4, ink::white);
    bystander.label(frame.eye, "eye", {-14, 24});
    return bystander.picture();
}

}  // namespace raylab::ray_generation
