#pragma once

#include "raylab/accelerator/light_buffer/light_buffer.h"

#include <limits>
#include <memory>
#include <vector>

namespace raylab {

/// A structure with a light buffer for each light that has a place: rays that a buffer knows nothing about, and all
/// that ask for the nearest hit, are the structure's. Rays say which light they go to by Traversal::toward().
/// A buffer whose lists are longer in the mean than `longest` is not kept: few of its cells see everything.
class LightBuffered final : public Accelerator {
public:
    LightBuffered(std::unique_ptr<Accelerator> structure, const Scene& scene, const LightBufferOptions& options = {},
                  double longest = std::numeric_limits<double>::infinity());

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        return structure_->closest(ray, traversal);
    }
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;
    std::size_t buffers() const;  // how many lights have one
    Outline outline() const override { return structure_->outline(); }
    std::vector<Visit> visits(const Ray& ray) const override { return structure_->visits(ray); }

private:
    std::unique_ptr<Accelerator> structure_;
    std::vector<std::optional<LightBuffer>> buffers_;  // one a light of the scene; absent: it has none
    std::size_t primitive_bytes_ = 0;
};

}  // namespace raylab
