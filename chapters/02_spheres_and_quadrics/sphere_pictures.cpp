#include "judge.h"
#include "pictures.h"

#include "raylab/image/draw.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/pigment.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/picture/first_hit_picture.h"
#include "raylab/tracer/shading/surface_point.h"

#include <cmath>
#include <numbers>

namespace raylab {

namespace {

/// A camera and the one sphere it looks at, or stands on.
struct View {
    CameraFrame frame;
    Sphere sphere;
};

// One query for each pixel, row by row.
SphereWorkload queries_of(const View& view) {
    SphereWorkload workload{"picture", "a ray through each pixel's centre", {}, {}};
    for (int y = 0; y < view.frame.image.height; ++y)
        for (int x = 0; x < view.frame.image.width; ++x)
            workload.queries.push_back({eye_ray(view.frame, x + 0.5, y + 0.5), view.sphere});
    return workload;
}

Answers answers_in(const View& view, const std::string& method) {
    return answers_of(find_method(ray_sphere_methods(), method), queries_of(view));
}

// A picture from one answer for each pixel.
template <class Color>
Image picture_of(const View& view, const Answers& answers, const Color& color) {
    Image image(view.frame.image.width, view.frame.image.height);
    const SphereWorkload workload = queries_of(view);
    std::size_t pixel = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x, ++pixel)
            image.at(x, y) = to_pixel(color(workload.queries[pixel].ray, answers[pixel]));
    return image;
}

Vec3d point_at(const Ray& ray, double t) { return convert<double>(ray.origin) + convert<double>(ray.direction) * t; }

// Shaded with the normal where the method says that the ray hits.
Image lit_sphere(const View& view, const Answers& answers) {
    const Vec3d to_light = shoulder_light(view.frame);
    return picture_of(view, answers, [&](const Ray& ray, const std::optional<double>& t) {
        if (!t) return sky;
        const Vec3d normal = glm::normalize(point_at(ray, *t) - convert<double>(view.sphere.center));
        return Color{0.79, 0.35, 0.0} * (0.15 + 0.85 * std::max(0.0, dot(normal, glm::normalize(to_light))));
    });
}

// The exact picture, pale, and every pixel with a wrong decision: a miss dark, a false hit bright.
Image wrong_pixels(const View& view, const Answers& answers, const Answers& exact) {
    Image image = lit_sphere(view, exact);
    std::size_t pixel = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x, ++pixel) {
            Pixel& p = image.at(x, y);
            p = {0.7f + 0.3f * p.r, 0.7f + 0.3f * p.g, 0.7f + 0.3f * p.b};
            if (exact[pixel] && !answers[pixel]) p = ink::blue;
            if (!exact[pixel] && answers[pixel]) p = ink::vermilion;
        }
    return image;
}

View far_view(int size) {
    constexpr double distance = 4096;
    const Vec3d away = glm::normalize(Vec3d{1, 0.5, 2});  // not along an axis, which would flatter every method
    const double fov_y = 2 * std::atan(1.35 / distance) * 180 / std::numbers::pi;
    return {camera_frame({.position = away * distance, .target = {0, 0, 0}, .projection = Perspective{fov_y}},
                         {size, size}),
            {{0, 0, 0}, 1}};
}

// An orthographic view, in which the rays start at different points, so that each rounds c = f.f - r^2 in its own way.
// (In perspective all start at the eye, and the floor would only be at the wrong height.)
View floor_view(int width, int height) {
    constexpr double radius = 1e7;
    const Vec3d up = glm::normalize(Vec3d{1, 3, 2});
    const Sphere sphere{convert<float>(up * -(radius + 1)), static_cast<float>(radius)};
    const Vec3d foot = up * (radius - glm::length(convert<double>(sphere.center)));
    const Vec3d aside = glm::normalize(cross(up, Vec3d{1, 0, 0}));
    const Vec3d along = cross(up, aside);
    return {camera_frame({.position = foot + up * 3.0 + aside * 4.0 + along * 2.0,
                          .target = foot,
                          .up = up,
                          .projection = Orthographic{4}},
                         {width, height}),
            sphere};
}

// A chequered floor: the squares are those of the plane perpendicular to `up`.
Image chequered_floor(const View& view, const Answers& answers) {
    const Vec3d up = glm::normalize(view.frame.eye - convert<double>(view.sphere.center));
    const Vec3d east = glm::normalize(cross(up, Vec3d{1, 0, 0}));
    const Vec3d north = cross(up, east);
    return picture_of(view, answers, [&](const Ray& ray, const std::optional<double>& t) {
        if (!t) return sky;
        const Vec3d point = point_at(ray, *t);
        const double cell = std::floor(2 * dot(point, east)) + std::floor(2 * dot(point, north));
        return std::fmod(std::abs(cell), 2) < 1 ? Color{0.85, 0.8, 0.7} : Color{0.13, 0.2, 0.3};
    });
}

// The plane through the floor's highest point, in float.
Answers plane_answers(const View& view) {
    const Vec3d up = glm::normalize(view.frame.eye - convert<double>(view.sphere.center));
    const Vec3f point = convert<float>(convert<double>(view.sphere.center) + up * double{view.sphere.radius});
    const Vec3f normal = convert<float>(up);
    Answers answers;
    const SphereWorkload workload = queries_of(view);
    for (const auto& [ray, sphere] : workload.queries) {
        const float t = dot(point - ray.origin, normal) / dot(ray.direction, normal);
        answers.push_back(contains(ray.range, t) ? std::optional<double>(t) : std::nullopt);
    }
    return answers;
}

}  // namespace

std::vector<Step> far_sphere_steps(const ChapterRun& run) {
    const View view = far_view(run.sized(640, 150));
    const auto by = [=](const std::string& method) { return answers_in(view, method); };
    const std::string exact = "filtered exact, double + exact";
    return {{"far_exact", [=] { return lit_sphere(view, by(exact)); }},
            {"far_textbook", [=] { return lit_sphere(view, by("textbook, float")); }},
            {"far_wrong", [=] { return wrong_pixels(view, by("textbook, float"), by(exact)); }},
            {"far_reformulated", [=] { return lit_sphere(view, by("reformulated, float")); }}};
}

std::vector<Step> floor_steps(const ChapterRun& run) {
    const View view = floor_view(run.sized(640, 180), run.sized(427, 120));
    return {{"floor_double", [=] { return chequered_floor(view, answers_in(view, "stable, double")); }},
            {"floor_float", [=] { return chequered_floor(view, answers_in(view, "stable, float")); }},
            {"floor_plane", [=] { return chequered_floor(view, plane_answers(view)); }}};
}

}  // namespace raylab
