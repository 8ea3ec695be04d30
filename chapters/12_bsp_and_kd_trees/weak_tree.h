#pragma once

#include "raylab/accelerator/primitives.h"
#include "raylab/accelerator/split_tree/split_tree.h"

#include <string>
#include <vector>

namespace raylab::split {

/// Mistakes of a kd-tree's traversal, in floats as in published listings, or without any but rounding.
enum class Mistake {
    rounding,         // none, except that a plane's t is a rounded float; hits are kept wherever they are found
    in_doubles,       // the same with doubles: the textbook's visited_halves()
    only_inside,      // a hit counts only if t lies between the cell's rounded ends
    first_found,      // the first cell with a hit ends the traversal, wherever the hit is
    nan_goes_beyond,  // "both if begin < t < end, near if t >= end, else far": NaN, of a ray in the plane, goes to the
                      // far side
};
std::string words(Mistake mistake);

/// The lab's kd-tree, traversed with one mistake.
class WeakTree final : public Accelerator {
public:
    WeakTree(const Scene& scene, Mistake mistake);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override { return closest(ray, traversal).has_value(); }
    std::size_t bytes() const override;

private:
    struct Cell {
        std::uint32_t node;
        Interval<double> span;  // whose ends are floats, except in doubles
    };
    WeakTree(const SortedPrimitives& sorted, Mistake mistake);
    Cell whole(const Ray& ray) const;
    std::vector<Cell> children(const Cell& cell, const Ray& ray) const;  // the nearer one last

    Mistake mistake_;
    SplitTree tree_;
    Primitives bounded_, unbounded_;
};

}  // namespace raylab::split
