#pragma once

#include "raylab/accelerator/bvh8/bvh8_contents.h"
#include "raylab/accelerator/bvh8/bvh8_leaves.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/accelerator/bvh8/bvh8_walk_in_doubles.h"

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace raylab {

/// The nearest hits of rays whose traversals take turns.
class NearestInTurns final : public Bvh8Turns {
public:
    NearestInTurns(const Bvh8Contents& contents, std::span<const Ray> rays, Traversal& traversal)
        : contents_(contents), rays_(rays), traversal_(traversal), hits_(rays.size()) {}

    const Asked* next(std::size_t place) override {
        if (begun_ == rays_.size()) return nullptr;
        auto& here = places_[place];
        here.emplace(contents_, rays_[begun_], begun_, traversal_);
        ++begun_;
        return &here->asked;
    }

    void ended(std::size_t place) override { hits_[places_[place]->number] = places_[place]->leaves.hit(); }

    void exceeds_floats(std::size_t place) override {
        walk_in_doubles(contents_.tree(), places_[place]->asked.query, places_[place]->leaves, traversal_);
        ended(place);
    }

    std::vector<std::optional<Hit>> hits() && { return std::move(hits_); }

private:
    struct Place {
        std::size_t number;  // of the ray
        NearestLeaves leaves;
        Asked asked;
        Place(const Bvh8Contents& contents, const Ray& ray, std::size_t of_ray, Traversal& traversal)
            : number(of_ray),
              leaves(contents, ray, traversal),
              asked{{ray, leaves.end(), contents.number_left_by(ray)}, leaves} {}
    };
    const Bvh8Contents& contents_;
    std::span<const Ray> rays_;
    Traversal& traversal_;
    std::array<std::optional<Place>, under_way> places_;
    std::size_t begun_ = 0;
    std::vector<std::optional<Hit>> hits_;
};

}  // namespace raylab
