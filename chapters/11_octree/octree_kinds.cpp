#include "octree_kinds.h"

#include "raylab/accelerator/octree/octree.h"

namespace raylab::octrees {

namespace {

template <class Structure>
StructureMethod limited(const std::string& name, const OctreeLimits& limits) {
    return {name, "exact", [=](const Scene& scene) { return std::make_unique<Structure>(scene, limits); }};
}

}  // namespace

StructureMethod textbook(const std::string& name, const std::string& number,
                         const TextbookOctree::NextPoint& next_point, TextbookOctree::End end) {
    return {name, number, [=](const Scene& scene) { return std::make_unique<TextbookOctree>(scene, next_point, end); }};
}

StructureMethod octree_by_points(const std::string& name, const OctreeLimits& limits) {
    return limited<OctreePoint>(name, limits);
}
StructureMethod octree_by_names(const std::string& name, const OctreeLimits& limits) {
    return limited<OctreeHash>(name, limits);
}
StructureMethod octree_by_times(const std::string& name, const OctreeLimits& limits) {
    return limited<Octree>(name, limits);
}
StructureMethod octree_by_blocks(const std::string& name, const OctreeLimits& limits) {
    return limited<OctreeSeads>(name, limits);
}

}  // namespace raylab::octrees
