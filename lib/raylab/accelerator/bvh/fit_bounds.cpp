#include "raylab/accelerator/bvh/fit_bounds.h"

namespace raylab {

namespace {

void fit(std::span<const Ball> balls, Sphere& sphere) { sphere = bounding_sphere(balls); }
void fit(std::span<const Ball> balls, Slabs& slabs) { slabs = bounding_slabs(balls); }

template <class One>
class Fitting {
public:
    Fitting(const BoxTree& tree, const Primitives& ordered) : tree_(tree), bounds_(tree.nodes.size()) {
        for (std::size_t i = 0; i < ordered.size(); ++i) {
            begin_.push_back(balls_.size());
            const Hull hull = ordered.hull(i);
            balls_.insert(balls_.end(), hull.begin(), hull.end());
        }
        begin_.push_back(balls_.size());
    }

    std::vector<std::array<One, 2>> bounds() {
        if (tree_.order.size() == 1) {  // the second child is empty
            fit(balls_, bounds_[0][0]);
            fit({}, bounds_[0][1]);
        } else if (!tree_.nodes.empty()) {
            fit_children(0);
        }
        return std::move(bounds_);
    }

private:
    struct Slice {
        std::size_t begin, end;
    };

    // Computes the bounds of a node's children and returns the places of the order that lie below the node.
    Slice fit_children(std::size_t node) {
        const Slice first = fit_child(node, 0), second = fit_child(node, 1);
        return {first.begin, second.end};
    }

    Slice fit_child(std::size_t node, std::size_t side) {
        const std::size_t first = tree_.nodes[node].first[side], count = tree_.nodes[node].count[side];
        const Slice slice = count > 0 ? Slice{first, first + count} : fit_children(first);
        const std::size_t begin = begin_[slice.begin];
        fit(std::span(balls_).subspan(begin, begin_[slice.end] - begin), bounds_[node][side]);
        return slice;
    }

    const BoxTree& tree_;
    Hull balls_;                      // of all primitives, in order
    std::vector<std::size_t> begin_;  // where the balls of each primitive begin, and the end
    std::vector<std::array<One, 2>> bounds_;
};

}  // namespace

template <class One>
std::vector<std::array<One, 2>> fit_bounds(const BoxTree& tree, const Primitives& ordered) {
    return Fitting<One>(tree, ordered).bounds();
}

template <class One>
One fit_bound(const Primitives& primitives) {
    Hull balls;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Hull hull = primitives.hull(i);
        balls.insert(balls.end(), hull.begin(), hull.end());
    }
    One bound;
    fit(balls, bound);
    return bound;
}

template <>
Box fit_bound(const Primitives& primitives) {
    Box box;
    for (std::size_t i = 0; i < primitives.size(); ++i) box = unite(box, *primitives.bounds(i));
    return box;
}

template std::vector<std::array<Sphere, 2>> fit_bounds(const BoxTree&, const Primitives&);
template std::vector<std::array<Slabs, 2>> fit_bounds(const BoxTree&, const Primitives&);
template Sphere fit_bound(const Primitives&);
template Slabs fit_bound(const Primitives&);

}  // namespace raylab
