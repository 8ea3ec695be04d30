#pragma once

#include "raylab/accelerator/bvh8/bvh8_split.h"

#include <span>
#include <vector>

namespace raylab::bvh8_parts {

/// Splits of the tree's top parts, those of the root and its halves made ahead, before they are asked for.
///
/// A root has eight children after seven splits, and threads that share the work of each start twice for it, which
/// costs a small tree as much as it saves. So a thread for each half splits it and its halves. Which parts the root
/// splits depends on their boxes, and mostly it is these. One that it does not split was only sorted too soon: to be
/// split again moves none of its references.
class RootSplits {
public:
    RootSplits(References& references, std::span<const ReferenceRange> parts_of_root, int threads);

    References::Sides split(const ReferenceRange& part, int depth, int threads);

private:
    struct Known {
        ReferenceRange part;
        References::Sides sides;
    };

    void split_halves(const References::Sides& halves, int threads);

    References& references_;
    std::vector<Known> known_;
};

}  // namespace raylab::bvh8_parts
