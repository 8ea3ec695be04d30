#include "pictures.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/number_text.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/mesh/vertex_normals.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/tracer/shading/ray_start.h"

#include <fmt/format.h>

namespace raylab::shadows {

Scene elsewhere(const Scene& scene, double scale, const Vec3d& by) {
    Scene moved = scene;
    const auto steps = AffineSteps::scale(Vec3d(scale)).then(AffineSteps::translate(by));
    for (Object& object : moved.objects) object.placement = AffineSteps::of(object.placement).then(steps).rounded();
    const auto carried = [&](const Vec3d& p) { return p * scale + by; };
    moved.camera.position = carried(scene.camera.position);
    moved.camera.target = carried(scene.camera.target);
    for (Light& light : moved.lights)
        if (auto* point = std::get_if<PointLight>(&light.kind)) point->position = carried(point->position);
    for (Material& material : moved.materials)
        if (auto* checker = std::get_if<Checker>(&material.diffuse)) checker->size *= scale;
    return moved;
}

Image coarse_ball(WhittedOptions::Shadows shadows, const ChapterRun& run) {
    Scene scene;
    scene.image = run.sized(ImageSize{640, 480}, ImageSize{160, 120});
    scene.camera = {.position = {0, 0, 5}, .target = {0, 0, 0}, .projection = Orthographic{2.2}};
    scene.background = {.color = {1, 1, 1}, .ambient = {0.12, 0.12, 0.14}};
    scene.materials = {{.name = "clay", .ambient = {0.8, 0.5, 0.35}, .diffuse = Color{0.8, 0.42, 0.24}}};
    scene.lights = {{.kind = DistantLight{{1, -0.3, -0.25}}}};
    scene.objects = {{.shape = std::make_shared<const Mesh>(with_vertex_normals(icosphere(2)))}};
    return chapter_picture(scene, scene.image, run, {.shadows = shadows});
}

std::vector<std::vector<std::string>> worked_start_rows(const Scene& scene) {
    const Vec3d aim{0.9, 0, 1.8};  // on the table
    const Ray ray{.origin = convert<float>(scene.camera.position),
                  .direction = convert<float>(glm::normalize(aim - scene.camera.position))};
    Traversal traversal;
    const auto hit = *make_accelerator("list", scene)->closest(ray, traversal);
    const SurfacePoint at = surface_point(scene, ray, hit);
    const Vec3f rounded = ray.origin + cast<float>(hit.t) * ray.direction, start = start_beside(at, at.normal);
    const Disk& table = std::get<Disk>(at.object->shape);
    const auto height = [&](const Vec3d& p) {
        const double metres = dot(at.normal, p - convert<double>(table.center));
        return fmt::format("{}{} nm", metres > 0 ? "+" : "", number_text(1e9 * metres));
    };
    const auto words = [](const Vec3d& p) { return fmt::format("{:.8f}, {:.8f}, {:.8f}", p.x, p.y, p.z); };
    return {{"O + t D in floats", words(convert<double>(rounded)), height(convert<double>(rounded))},
            {"put back on the surface, in doubles", words(at.position), height(at.position)},
            {"its error bound e", number_text(1e9 * at.error) + " nm", ""},
            {"the start S, beside it", words(convert<double>(start)), height(convert<double>(start))}};
}

}  // namespace raylab::shadows
