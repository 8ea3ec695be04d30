#include "raylab/experiment/textbook/textbook_light_buffer.h"

#include "raylab/accelerator/light_buffer/light_through_list.h"
#include "raylab/geometry/largest_coordinate.h"
#include "raylab/scene/scene.h"

#include <algorithm>

namespace raylab {

TextbookLightBuffer::TextbookLightBuffer(const Scene& scene, const LightBufferOptions& options)
    : primitives_(std::make_shared<const Primitives>(scene)), all_(make_accelerator("list", scene)) {
    for (const Light& light : scene.lights)
        if (const auto* point = std::get_if<PointLight>(&light.kind))
            buffers_.emplace_back(primitives_, point->position, options);
}

std::size_t TextbookLightBuffer::bytes() const {
    std::size_t sum = primitives_->bytes() + all_->bytes();
    for (const LightBuffer& buffer : buffers_) sum += buffer.bytes();
    return sum;
}

const LightBuffer* TextbookLightBuffer::buffer_towards(const Ray& ray) const {
    const Vec3d origin = convert<double>(ray.origin),
                way = convert<double>(ray.direction) * cast<double>(ray.range.max);
    // Rays are floats, and end a little before the light.
    const auto found = std::ranges::find_if(buffers_, [&](const LightBuffer& buffer) {
        const Vec3d straight = buffer.light() - origin;
        return glm::length(straight - way) < 1e-4 * glm::length(straight);
    });
    return found == buffers_.end() ? nullptr : &*found;
}

bool TextbookLightBuffer::occluded(const Ray& ray, Traversal& traversal) const {
    const LightBuffer* buffer = buffer_towards(ray);
    if (!buffer) return all_->occluded(ray, traversal);
    ++traversal.steps;
    const auto hits = [&](std::uint32_t place) { return primitives_->hits(place, ray, traversal); };
    if (std::ranges::any_of(buffer->everywhere(), hits)) return true;
    const Vec3d from_light = convert<double>(ray.origin) - buffer->light();
    const LightCell cell = light_cell(from_light, buffer->resolution());
    const auto entries = buffer->list(cell);
    const auto entry = [&](int i) { return entries[static_cast<std::size_t>(i)]; };
    const double left = light_through_list({.depth = largest_coordinate(from_light),
                                            .filled = buffer->cover(cell).depth,
                                            .entries = static_cast<int>(entries.size()),
                                            .begin = [&](int i) { return cast<double>(entry(i).depth); },
                                            .through = [&](int i) { return hits(entry(i).primitive) ? 0.0 : 1.0; }});
    return left == 0;
}

}  // namespace raylab
