#include "raylab/radiosity/radiosity_picture.h"

#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/scene/background.h"
#include "raylab/tracer/shading/surface_point.h"

#include <numbers>

namespace raylab {

namespace {

Color interpolated(const RadiosityView& view, const PatchPlace& place) {
    const Patch& patch = view.mesh.patches[place.patch];
    Color sum{0, 0, 0};
    for (std::uint32_t i = 0; i < patch.corner_count; ++i) sum += place.weights[i] * view.vertices[patch.vertices[i]];
    return sum;
}

// What arrives at a point from all patches: of each, its factor seen from the point if its centre is in view.
Color gathered(const RadiosityView& view, std::uint32_t at, const Vec3d& point, Traversal& traversal) {
    const Patch& here = view.mesh.patches[at];
    Color sum{0, 0, 0};
    for (std::uint32_t i = 0; i < view.mesh.patches.size(); ++i) {
        const Patch& other = view.mesh.patches[i];
        const Vec3d way = point - other.center;
        if (view.patches[i] == Color{0, 0, 0} || !(dot(way, other.normal) > 0)) continue;
        const double factor = contour_form_factor(point, here.normal, other.polygon());
        if (factor > 0 && view.visibility.sees(at, point, i, other.center, traversal)) sum += factor * view.patches[i];
    }
    return sum;
}

Color seen_color(const RadiosityView& view, const Accelerator& seen, RadiosityShading shading, const Ray& ray,
                 Traversal& traversal) {
    const Scene& scene = view.mesh.model.scene;
    const auto hit = seen.closest(ray, traversal);
    if (!hit) return background_color(scene.background, ray.direction);
    const SurfacePoint surface = surface_point(scene, ray, *hit);
    const bool from_front = dot(surface.normal, convert<double>(ray.direction)) < 0;
    const PatchPlace place =
        patch_at(view.mesh, hit->primitive.object, from_front ? FacetSide::front : FacetSide::back, surface.position);
    const Patch& patch = view.mesh.patches[place.patch];
    if (shading == RadiosityShading::patches) return view.patches[place.patch] / std::numbers::pi;
    if (shading == RadiosityShading::vertices) return interpolated(view, place) / std::numbers::pi;
    const Material& material = view.mesh.material(patch);
    const Color arrives = gathered(view, place.patch, surface.position, traversal) + view.direct[place.patch];
    return material.emission + patch_reflectance(view.mesh, patch) * arrives / std::numbers::pi;
}

}  // namespace

Image radiosity_picture(const RadiosityView& view, const CameraFrame& frame, RadiosityShading shading,
                        const EyePictureOptions& options) {
    // Not what hides patches from each other: to the eye, one-sided shapes are one-sided.
    const auto seen = make_accelerator("auto", view.mesh.model.scene);
    return eye_picture_by_tiles(frame, options, [&](const auto& draw) {
        Traversal traversal;
        draw([&](const Ray& ray) { return seen_color(view, *seen, shading, ray, traversal); });
    });
}

}  // namespace raylab
