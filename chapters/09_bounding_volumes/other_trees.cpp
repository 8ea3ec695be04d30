#include "other_trees.h"

#include "slab_ray.h"

#include "raylab/accelerator/bvh/bvh_members.h"
#include "raylab/experiment/textbook/textbook_bvh.h"

#include <string>

namespace raylab::volumes {

namespace {

/// The tree of boxes with another box test than the lab's.
template <class WeakRay>
struct WeakBounds : BoxBounds {
    using PreparedRay = WeakRay;
};

template <class WeakRay>
StructureMethod weak(const std::string& name, const std::string& number) {
    return {name, number, [](const Scene& scene) { return std::make_unique<Bvh<WeakBounds<WeakRay>>>(scene); }};
}

StructureMethod cut(const std::string& name, SplitRule rule, std::size_t largest_leaf) {
    return {name, "exact", [=](const Scene& scene) {
                return std::make_unique<BoxBvh>(scene, BoxTreeOptions{.rule = rule, .largest_leaf = largest_leaf});
            }};
}

}  // namespace

std::vector<StructureMethod> cuts() {
    return {cut("cut at the median", SplitRule::median, 4), cut("by cost, 16 bins", SplitRule::binned, 8),
            cut("by cost, everywhere", SplitRule::sweep, 8)};
}

StructureMethod down_to(std::size_t largest_leaf) {
    return cut(std::to_string(largest_leaf), SplitRule::median, largest_leaf);
}

std::vector<StructureMethod> weak_trees() {
    return {weak<FminFmax>("boxes: fmin and fmax", "float"), weak<MinMax>("boxes: std::min and max", "float"),
            weak<Products>("boxes: products", "float"), weak<Ordered>("boxes: ordered", "float"),
            weak<Padded>("boxes: padded", "float")};
}

StructureMethod textbook_tree(const std::string& name) {
    return {name, "double", [](const Scene& scene) { return std::make_unique<TextbookBvh>(scene); }};
}

}  // namespace raylab::volumes
