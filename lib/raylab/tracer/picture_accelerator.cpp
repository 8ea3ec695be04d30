#include "raylab/tracer/picture_accelerator.h"

#include "raylab/accelerator/on_demand.h"
#include "raylab/tracer/whitted_picture.h"

#include <memory>

namespace raylab {

namespace {

// Fewer primitives are found as fast without: there is little to be saved (chapter 13 has the measurements).
constexpr std::size_t few = 64;

// To draw a triangle costs as much as the tree's way to the first hit does for two or three rays (instructions counted
// in the bunny's picture); a wide tree's is shorter.
constexpr double rays_for_one_primitive = 4;

std::size_t primitives_in(const Scene& scene) {
    std::size_t count = 0;
    for (const Object& object : scene.objects) {
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&object.shape);
        count += mesh ? (*mesh)->faces.size() : 1;
    }
    return count;
}

bool pays(std::size_t primitives, const CameraFrame& frame, const PixelSamples& samples, bool eye_rays_only) {
    if (primitives <= few) return false;
    if (eye_rays_only) return true;  // drawing is less work than any tree
    const double rays = 1.0 * frame.image.width * frame.image.height * samples.count();
    return rays >= rays_for_one_primitive * static_cast<double>(primitives);
}

}  // namespace

PictureAccelerator::PictureAccelerator(const std::string& name, const Scene& scene, const CameraFrame& frame,
                                       const WhittedOptions& options, const PixelSamples& samples, ItemBufferUse use) {
    const bool eye_rays_only = needs_local_light_only(scene, options);
    const bool free_to_choose = use == ItemBufferUse::where_it_pays && name == "auto";
    const bool draws = use == ItemBufferUse::always ||
                       (free_to_choose && pays(primitives_in(scene), frame, samples, eye_rays_only));
    if (draws && eye_rays_only)
        structure_ = std::make_unique<OnDemand>(name, scene);
    else
        structure_ = make_accelerator(name, scene);
    if (draws) buffer_.emplace(scene, frame, *structure_);
}

const Accelerator& PictureAccelerator::finds() const {
    if (buffer_) return *buffer_;
    return *structure_;
}

}  // namespace raylab
