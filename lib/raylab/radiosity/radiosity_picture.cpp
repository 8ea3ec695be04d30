#include "raylab/radiosity/radiosity_picture.h"

#include "raylab/radiosity/final_gather.h"
#include "raylab/scene/background.h"
#include "raylab/tracer/shading/surface_point.h"

#include <numbers>

namespace raylab {

Color interpolated_radiosity(const RadiosityView& view, const PatchPlace& place) {
    const Patch& patch = view.mesh.patches[place.patch];
    Color sum{0, 0, 0};
    for (std::uint32_t i = 0; i < patch.corner_count; ++i) sum += place.weights[i] * view.vertices[patch.vertices[i]];
    return sum;
}

namespace {

Color seen_color(const RadiosityView& view, const FinalGather& gather, const Accelerator& seen,
                 RadiosityShading shading, const Ray& ray, Traversal& traversal) {
    const Scene& scene = view.mesh.model.scene;
    const auto hit = seen.closest(ray, traversal);
    if (!hit) return background_color(scene.background, ray.direction);
    const SurfacePoint surface = surface_point(scene, ray, *hit);
    const bool from_front = dot(surface.normal, convert<double>(ray.direction)) < 0;
    const PatchPlace place =
        patch_at(view.mesh, hit->primitive.object, from_front ? FacetSide::front : FacetSide::back, surface.position);
    const Color radiosity = shading == RadiosityShading::patches ? view.patches[place.patch]
                            : shading == RadiosityShading::vertices
                                ? interpolated_radiosity(view, place)
                                : gather.at(place.patch, surface.position, {}, traversal).radiosity;
    return radiosity / std::numbers::pi;
}

}  // namespace

Image radiosity_picture(const RadiosityView& view, const CameraFrame& frame, RadiosityShading shading,
                        const EyePictureOptions& options) {
    // Not what hides patches from each other: to the eye, one-sided shapes are one-sided.
    const FinalGather gather(view);
    const auto seen = make_accelerator("auto", view.mesh.model.scene);
    return eye_picture_by_tiles(frame, options, [&](const auto& draw) {
        Traversal traversal;
        draw([&](const Ray& ray) { return seen_color(view, gather, *seen, shading, ray, traversal); });
    });
}

}  // namespace raylab
