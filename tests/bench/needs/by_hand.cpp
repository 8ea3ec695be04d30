#include "pictures.h"

#include "raylab/geometry/intersect.h"
#include "raylab/tracer/eye_picture.h"
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

using namespace raylab;

namespace {

// What there is to it, in doubles.
struct OneSphere {
    Sphere sphere;
    Vec3d center;
    double radius;
    Color background, ambient, diffuse, specular;
    double shininess;
    Vec3d light;
    Color light_color;
};

OneSphere taken_from(const Scene& scene) {
    const auto& sphere = std::get<Sphere>(scene.objects.at(0).shape);
    const Material& material = scene.materials.at(scene.objects[0].front);
    const Light& light = scene.lights.at(0);
    return {sphere,
            convert<double>(sphere.center),
            sphere.radius,
            scene.background.color,
            material.ambient * scene.background.ambient,
            std::get<Color>(material.diffuse),
            material.specular,
            material.shininess,
            std::get<PointLight>(light.kind).position,
            light.color};
}

double largest(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

Color shade(const OneSphere& scene, const Ray& ray, double t) {
    // The hit, put back onto the sphere; the normal there, scaled to size one before it is squared.
    const Vec3d direction = convert<double>(ray.direction);
    const Vec3d from_center = convert<double>(ray.origin) + direction * t - scene.center;
    const Vec3d point = scene.center + from_center * (scene.radius / glm::length(from_center));
    const Vec3d gradient = from_center * 2.0;
    const Vec3d normal = glm::normalize(gradient / largest(gradient));

    const Vec3d way = scene.light - point;
    const Vec3d to_light = way / glm::length(way);
    const double cosine = dot(normal, to_light);
    if (!(cosine > 0)) return scene.ambient;
    const double highlight = phong_specular(normal, to_light, -glm::normalize(direction), scene.shininess);
    return scene.ambient + scene.light_color * (scene.diffuse * cosine + scene.specular * highlight);
}

}  // namespace

Image by_hand(const Scene& scene, const CameraFrame& frame) {
    const OneSphere one = taken_from(scene);
    Image image(frame.image.width, frame.image.height);
    Decisions decisions;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Ray ray = eye_ray(frame, x + 0.5, y + 0.5);
            const auto hit = intersect(ray, one.sphere, decisions);
            image.at(x, y) = to_pixel(hit ? shade(one, ray, hit->t) : one.background);
        }
    return image;
}
