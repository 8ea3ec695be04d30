#pragma once

#include "raylab/accelerator/primitives.h"

namespace raylab {

/// Brute force: every primitive is tested against every ray. What all other structures are judged by.
class List final : public Accelerator {
public:
    explicit List(const Scene& scene) : primitives_(scene) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        Nearest nearest(ray);
        for (std::size_t i = 0; i < primitives_.size(); ++i) primitives_.test(i, ray, nearest, traversal);
        return nearest.hit();
    }

    bool occluded(const Ray& ray, Traversal& traversal) const override {
        for (std::size_t i = 0; i < primitives_.size(); ++i) {
            if (primitives_.hits(i, ray, traversal)) return true;
        }
        return false;
    }

    std::size_t bytes() const override { return primitives_.bytes(); }

private:
    Primitives primitives_;
};

}  // namespace raylab
