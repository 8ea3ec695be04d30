#pragma once

#include "raylab/accelerator/bvh8/bvh8_contents.h"
#include "raylab/accelerator/bvh8/bvh8_leaves.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/accelerator/bvh8/bvh8_walk_in_doubles.h"

#include <array>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace raylab {

/// The answers to rays whose traversals take turns: their nearest hits, which NearestLeaves find, or whether there is
/// any, which AnyLeaves do.
template <class Leaves>
class AnswersInTurns final : public Bvh8Turns {
    static constexpr bool any_will_do = std::is_same_v<Leaves, AnyLeaves>;
    using Answer = std::conditional_t<any_will_do, bool, std::optional<Hit>>;

public:
    AnswersInTurns(const Bvh8Contents& contents, std::span<const Ray> rays, Traversal& traversal)
        : contents_(contents), rays_(rays), traversal_(traversal), answers_(rays.size()) {}

    const Asked* next(std::size_t place) override {
        while (begun_ != rays_.size()) {
            auto& here = places_[place];
            here.emplace(contents_, rays_[begun_], begun_, traversal_);
            ++begun_;
            if constexpr (any_will_do) {
                if (here->leaves.is_hit_at_once()) {
                    answers_[here->number] = true;
                    continue;
                }
            }
            return &here->asked;
        }
        return nullptr;
    }

    void ended(std::size_t place) override {
        Place& here = *places_[place];
        if constexpr (any_will_do)
            answers_[here.number] = here.leaves.is_hit();
        else
            answers_[here.number] = here.leaves.hit();
    }

    void exceeds_floats(std::size_t place) override {
        walk_in_doubles(contents_.tree(), places_[place]->asked.query, places_[place]->leaves, traversal_);
        ended(place);
    }

    std::vector<Answer> answers() && { return std::move(answers_); }

private:
    struct Place {
        std::size_t number;  // of the ray
        Leaves leaves;
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
    std::vector<Answer> answers_;
};

}  // namespace raylab
