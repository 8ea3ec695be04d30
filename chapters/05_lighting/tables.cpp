#include "tables.h"

#include "surfaces.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/phong_specular.h"
#include "raylab/tracer/shading/illumination.h"
#include "raylab/tracer/shading/surface_point.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::lighting {

namespace {

std::string words(const Vec3d& v) { return fmt::format("{:.3f}, {:.3f}, {:.3f}", v.x, v.y, v.z); }
std::string number(double value) { return fmt::format("{:.3f}", value); }

}  // namespace

Rows worked_point_rows(const Scene& scene) {
    const Vec3d eye = scene.camera.position, aim{-0.46, 0.96, 0.79};  // on the ball, beside its highlight
    const Ray ray{.origin = convert<float>(eye), .direction = convert<float>(glm::normalize(aim - eye))};
    Traversal traversal;
    const auto accelerator = make_accelerator("list", scene);
    const SurfacePoint at = surface_point(scene, ray, *accelerator->closest(ray, traversal));
    const Material& material = material_of(scene, at, convert<double>(ray.direction));
    const Light& light = scene.lights[0];
    const Illumination seen = *illumination(light, at.position);
    const Vec3d n = at.normal, l = seen.to_light, v = -glm::normalize(convert<double>(ray.direction));
    const double cosine = dot(n, l);
    const Vec3d r = 2 * cosine * n - l;
    const double highlight = phong_specular(n, l, v, material.shininess);
    const Color diffuse = diffuse_color(scene, at, convert<double>(ray.direction));
    const Color ambient = material.ambient * scene.background.ambient;
    return {{"P, the point", words(at.position)},
            {"N", words(n)},
            {"L", words(l)},
            {"V", words(v)},
            {"d, the distance of the light", number(seen.distance)},
            {"I, what arrives by (1): red, green, blue", words(seen.color)},
            {"N·L", number(cosine)},
            {"R = 2 (N·L) N − L", words(r)},
            {"R·V", number(dot(r, v))},
            {fmt::format("(R·V)^{:g}", material.shininess), number(highlight)},
            {"ambient term", words(ambient)},
            {"diffuse term", words(seen.color * (diffuse * cosine))},
            {"specular term", words(seen.color * (material.specular * highlight))}};
}

std::vector<std::string> normals_header() {
    return {"surface", "tangents", "three points, steps of 0.1", "0.01", "0.0001"};
}

Rows normals_rows(const ChapterRun& run) {
    Rows rows;
    for (const auto& surface : two_way_surfaces()) {
        rows.push_back({surface.name});
        rows.back().push_back(worst_lean(surface, surface.by_tangents, run.seed) < 1e-14 ? "below 1e-14" : "more");
        for (const double step : {0.1, 0.01, 0.0001})
            rows.back().push_back(fmt::format("{:.1g}", worst_lean_by_three_points(surface, step, run.seed)));
    }
    return rows;
}

}  // namespace raylab::lighting
