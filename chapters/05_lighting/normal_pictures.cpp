#include "normal_pictures.h"

#include "surfaces.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/draw.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/shading/surface_point.h"

#include <cmath>
#include <numbers>

namespace raylab::lighting {

namespace {

struct Parameters {
    double u, v;
};

constexpr Vec3d ellipsoid_radii{1, 0.7, 0.5};

// The parameters of a point of the ellipsoid: the inverse of (a cos u sin v, b sin u sin v, -c cos v).
Parameters parameters_of(const Vec3d& point) {
    const Vec3d unit = glm::normalize(point / ellipsoid_radii);
    return {std::atan2(unit.y, unit.x) / (2 * std::numbers::pi), std::acos(-unit.z) / std::numbers::pi};
}

// The corner of the grid cell that contains a point.
Parameters cell_of(const Parameters& p) {
    constexpr double cells_around = 24, cells_along = 12;
    return {std::floor(p.u * cells_around) / cells_around, std::floor(p.v * cells_along) / cells_along};
}

}  // namespace

Image draw_three_normals(const ChapterRun& run) {
    const TwoWaySurface surface = two_way_surfaces()[0];
    Scene scene;
    scene.image = {420, 290};
    scene.camera = {.position = {1, 1.4, 4}, .target = {0, 0, 0}, .projection = Perspective{28}};
    scene.materials = {{.name = "plain"}};
    scene.objects = {{.shape = Ellipsoid{{0, 0, 0}, convert<float>(ellipsoid_radii)}}};
    const auto accelerator = make_accelerator("list", scene);
    const auto frame = camera_frame(scene.camera, scene.image);

    const auto draw = [&](const auto& normal) {
        return eye_picture(
            frame, {.samples = {SamplePattern::jittered, 3, run.seed}, .threads = run.threads}, [&](const Ray& ray) {
                Traversal traversal;
                const auto hit = accelerator->closest(ray, traversal);
                if (!hit) return Color{1, 1, 1};
                return 0.5 * (normal(parameters_of(surface_point(scene, ray, *hit).position)) + Vec3d{1, 1, 1});
            });
    };
    const auto three_points = [&](const Parameters& p) {
        const auto [u, v] = cell_of(p);
        // At a pole all of a grid's first row is one point; half a cell further there are three different ones.
        return by_three_points(surface, u, v < 0.5 / 12 ? 0.5 / 12 : v, 1.0 / 24);
    };
    return side_by_side(
        {with_caption(draw([&](const Parameters& p) { return surface.by_gradient(p.u, p.v); }), "gradient", 17),
         with_caption(draw([&](const Parameters& p) { return surface.by_tangents(p.u, p.v); }), "tangents", 17),
         with_caption(draw(three_points), "three points of a grid", 17)});
}

}  // namespace raylab::lighting
