#include "pictures.h"

#include "raylab/geometry/intersect.h"
#include "raylab/geometry/sphere_filter.h"
#include "raylab/tracer/eye_picture.h"
#include "raylab/tracer/phong_specular.h"

#include <limits>

using namespace raylab;

namespace {

constexpr Interval<float> onward{0, std::numeric_limits<float>::infinity()};

// What there is to it, in doubles.
struct OneSphere {
    explicit OneSphere(const Scene& scene)
        : sphere(std::get<Sphere>(scene.objects.at(0).shape)),
          material(scene.materials.at(scene.objects[0].front)),
          light(std::get<PointLight>(scene.lights.at(0).kind).position),
          light_color(scene.lights[0].color),
          ambient(material.ambient * scene.background.ambient) {}

    Color shade(Vec3d near, Vec3d direction) const {
        // The normal, and the hit put back onto the sphere.
        Vec3d from_center = near - ball.center;
        Vec3d normal = from_center * (1 / glm::length(from_center));
        Vec3d point = ball.center + normal * radius;
        Vec3d way = light - point;
        Vec3d to_light = way * (1 / glm::length(way));
        const double cosine = dot(normal, to_light);
        if (!(cosine > 0)) return ambient;
        const double highlight = phong_specular(normal, to_light, -glm::normalize(direction), material.shininess);
        return ambient + light_color * (diffuse * cosine + material.specular * highlight);
    }

    Sphere sphere;
    sphere_filter::Ball ball{sphere};
    double radius = sphere.radius;
    Material material;
    Color diffuse = std::get<Color>(material.diffuse);
    Vec3d light;
    Color light_color, ambient;
};

// Where doubles do not tell: rare, and not worth a place in the loop.
[[gnu::cold, gnu::noinline]] std::optional<double> settled_t(Vec3d origin, Vec3d direction, const Sphere& sphere) {
    Decisions decisions;
    const auto hit = intersect(Ray{convert<float>(origin), convert<float>(direction)}, sphere, decisions);
    return hit ? std::optional(hit->t) : std::nullopt;
}

[[gnu::noinline]] void draw(const OneSphere& one, const CameraFrame& frame, Pixel* at) {
    for (int y = 0; y < frame.image.height; ++y, at += frame.image.width)
        for (int x = 0, width = frame.image.width; x < width; ++x) {
            auto ray = picture_ray(frame, x + 0.5, y + 0.5);
            Vec3d origin = convert<double>(convert<float>(ray.origin)), direction = convert<double>(convert<float>(ray.direction));
            auto verdict = sphere_filter::decide(origin, direction, onward, one.ball, Sides::both);
            using What = sphere_filter::Verdict::What;
            if (verdict.what == What::missed) continue;
            double t = verdict.at.t;
            if (verdict.what == What::undecided) [[unlikely]] {
                const auto settled = settled_t(origin, direction, one.sphere);
                if (!settled) continue;
                t = *settled;
            }
            at[x] = to_pixel(one.shade(origin + t * direction, direction));
        }
}

}  // namespace

Image by_hand(const Scene& scene, const CameraFrame& frame) {
    const OneSphere one(scene);
    Image image(frame.image.width, frame.image.height, to_pixel(scene.background.color));
    draw(one, frame, &image.at(0, 0));
    return image;
}
