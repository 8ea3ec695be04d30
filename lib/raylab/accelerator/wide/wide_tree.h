#pragma once

#include "raylab/accelerator/primitives.h"
#include "raylab/accelerator/wide/wide_node.h"
#include "raylab/accelerator/wide/wide_walk.h"

#include <cstdint>
#include <vector>

namespace raylab {

/// The lab's default: eight boxes, and eight triangles, tested at once. Triangles at rest are first tested in floats with
/// a bound of their error, and only what that leaves open is asked exactly; any other shape is asked one by one.
class WideTree final : public Accelerator {
public:
    explicit WideTree(const Scene& scene);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;

private:
    class Leaves;
    class ClosestLeaves;
    class OccludedLeaves;

    // Triangles that follow one another both in the order of the tree's numbers and in an object.
    struct Run {
        std::uint32_t first, object;
    };
    struct Sorted;

    explicit WideTree(const Scene& scene, const Sorted& sorted);
    Primitive primitive(std::size_t slot) const;
    std::uint32_t number_left_by(const Ray& ray) const;  // as WideQuery has it
    Triangle triangle(WideChild leaf, std::size_t place) const;
    void walk(WideWalks::Walk how, const WideQuery& query, Leaves& leaves, Traversal& traversal) const;

    const Scene* scene_;
    std::vector<Run> runs_;
    Primitives others_, unbounded_;
    WideNodes tree_;
    WideWalks walks_ = best_wide_walks();
};

}  // namespace raylab
