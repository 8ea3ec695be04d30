#pragma once

#include "raylab/accelerator/accelerator.h"

#include <memory>
#include <mutex>
#include <string>

namespace raylab {

/// Builds a structure when it is first queried, for structures that may never be needed.
class OnDemand final : public Accelerator {
public:
    OnDemand(std::string name, const Scene& scene, const BuildOptions& build = {})
        : name_(std::move(name)), scene_(scene), build_(build) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        return made().closest(ray, traversal);
    }
    bool occluded(const Ray& ray, Traversal& traversal) const override { return made().occluded(ray, traversal); }
    std::size_t bytes() const override { return made_ ? made_->bytes() : 0; }
    Outline outline() const override { return made().outline(); }
    std::vector<Visit> visits(const Ray& ray) const override { return made().visits(ray); }

private:
    const Accelerator& made() const {
        std::call_once(once_, [&] { made_ = make_accelerator(name_, scene_, build_); });
        return *made_;
    }

    std::string name_;
    const Scene& scene_;
    BuildOptions build_;
    mutable std::once_flag once_;
    mutable std::unique_ptr<Accelerator> made_;
};

}  // namespace raylab
