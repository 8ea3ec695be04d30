#pragma once

#include "raylab/accelerator/light_buffer/light_buffer.h"
#include "raylab/accelerator/primitives.h"

#include <memory>
#include <vector>

namespace raylab {

/// The lists of light buffers as textbooks search them: by light_cell() and light_through_list(), in doubles, where a
/// shadow ray is hidden if nothing is left of the light. A ray that does not end in one of the lights asks every
/// primitive, as does one for the nearest hit.
class TextbookLightBuffer final : public Accelerator {
public:
    explicit TextbookLightBuffer(const Scene& scene, const LightBufferOptions& options = {});

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        return all_->closest(ray, traversal);
    }
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;

private:
    const LightBuffer* buffer_towards(const Ray& ray) const;  // the light in which the ray ends; null: none

    std::shared_ptr<const Primitives> primitives_;
    std::unique_ptr<Accelerator> all_;
    std::vector<LightBuffer> buffers_;
};

}  // namespace raylab
