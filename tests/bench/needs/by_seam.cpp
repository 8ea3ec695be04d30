#include "pictures.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/eye_picture.h"
#include "raylab/tracer/reflected_light.h"

using namespace raylab;

namespace {

// Phong's terms of the scene's one light: no media, no feelers, no recursion.
Color shade(const Scene& scene, const Lamp& lamp, const Ray& ray, const Hit& hit) {
    const SurfacePoint at = surface_point(scene, ray, hit);
    const Vec3d direction = glm::normalize(convert<double>(ray.direction));
    const Material& material = material_of(scene, at, direction);
    const Color ambient = material.ambient * scene.background.ambient;
    const auto light = illumination(lamp, at.position);
    if (!light) return ambient;
    return ambient + reflected_light(*light, {at.position, facing(at.normal, direction), -direction},
                                     std::get<Color>(material.diffuse), material);
}

}  // namespace

Image by_seam(const Scene& scene, const CameraFrame& frame) {
    const auto accelerator = make_accelerator("auto", scene);
    Image image(frame.image.width, frame.image.height);
    const Lamp lamp(scene.lights.front());
    Traversal traversal;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Ray ray = eye_ray(frame, x + 0.5, y + 0.5);
            const auto hit = accelerator->closest(ray, traversal);
            image.at(x, y) = to_pixel(hit ? shade(scene, lamp, ray, *hit) : scene.background.color);
        }
    return image;
}
