#pragma once

#include "raylab/accelerator/bvh8/bvh8_parts.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace raylab::bvh8_parts {

/// The primitives, sorted into the parts of a tree.
class References {
public:
    explicit References(std::vector<Reference> all) : all_(std::move(all)) {}

    ReferenceRange all() const { return part_of(0, all_.size()); }
    std::span<const Reference> of(const ReferenceRange& part) const {
        return std::span(all_).subspan(part.begin, part.size());
    }

    /// Whether a part is one primitive, or so few triangles that they are tested at once.
    bool fit_in_leaf(const ReferenceRange& part) const;

    /// Sorts a part so that both sides together have the lowest expected cost. Beyond a certain depth it is simply
    /// halved, so that the depth is bounded.
    std::pair<ReferenceRange, ReferenceRange> split(const ReferenceRange& part, int depth);

private:
    ReferenceRange part_of(std::size_t begin, std::size_t end) const;
    std::pair<ReferenceRange, ReferenceRange> halves(const ReferenceRange& part) const;
    template <class Left>
    std::pair<ReferenceRange, ReferenceRange> partition(const ReferenceRange& part, const Left& goes_left);
    Split best_split(const ReferenceRange& part, const Binning& binning) const;

    std::vector<Reference> all_;
};

}  // namespace raylab::bvh8_parts
