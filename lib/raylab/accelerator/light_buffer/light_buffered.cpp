#include "raylab/accelerator/light_buffer/light_buffered.h"

#include "raylab/accelerator/primitives.h"

#include <algorithm>
#include <utility>

namespace raylab {

namespace {

const Vec3d* place_of(const Light& light) {
    if (const auto* point = std::get_if<PointLight>(&light.kind)) return &point->position;
    const auto* spot = std::get_if<SpotLight>(&light.kind);
    return spot ? &spot->position : nullptr;
}

}  // namespace

LightBuffered::LightBuffered(std::unique_ptr<Accelerator> structure, const Scene& scene,
                             const LightBufferOptions& options, double longest)
    : structure_(std::move(structure)) {
    const auto primitives = std::make_shared<const Primitives>(scene);
    for (const Light& light : scene.lights) {
        auto& buffer = buffers_.emplace_back();
        if (const Vec3d* place = place_of(light)) buffer.emplace(primitives, *place, options);
        if (buffer && buffer->mean_length() > longest) buffer.reset();
    }
    if (buffers() > 0) primitive_bytes_ = primitives->bytes();
}

std::size_t LightBuffered::buffers() const {
    const auto made = [](const std::optional<LightBuffer>& buffer) { return buffer.has_value(); };
    return static_cast<std::size_t>(std::ranges::count_if(buffers_, made));
}

std::size_t LightBuffered::bytes() const {
    std::size_t sum = structure_->bytes() + primitive_bytes_ + buffers_.capacity() * sizeof(buffers_[0]);
    for (const auto& buffer : buffers_) sum += buffer ? buffer->bytes() : 0;
    return sum;
}

bool LightBuffered::occluded(const Ray& ray, Traversal& traversal) const {
    const std::size_t light = traversal.light;
    if (light >= buffers_.size() || !buffers_[light]) return structure_->occluded(ray, traversal);
    if (const auto known = buffers_[light]->occluded(ray, traversal)) return *known;
    return structure_->occluded(ray, traversal);
}

}  // namespace raylab
