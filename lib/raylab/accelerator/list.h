#pragma once

#include "raylab/accelerator/primitives.h"

namespace raylab {

/// The nearest hit of all primitives; each one is tested.
inline std::optional<Hit> closest_of_all(const Primitives& primitives, const Ray& ray, Traversal& traversal) {
    Nearest nearest(ray);
    for (std::size_t i = 0; i < primitives.size(); ++i) primitives.test(i, ray, nearest, traversal);
    return nearest.hit();
}

/// Whether any primitive is hit, tested one after the other.
inline bool occluded_by_any(const Primitives& primitives, const Ray& ray, Traversal& traversal) {
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (primitives.hits(i, ray, traversal)) return true;
    return false;
}

/// Brute force: every ray is tested against every primitive. All other structures are judged by it.
class List final : public Accelerator {
public:
    explicit List(const Scene& scene) : primitives_(scene) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        return closest_of_all(primitives_, ray, traversal);
    }

    bool occluded(const Ray& ray, Traversal& traversal) const override {
        return occluded_by_any(primitives_, ray, traversal);
    }

    std::size_t bytes() const override { return primitives_.bytes(); }

private:
    Primitives primitives_;
};

}  // namespace raylab
