#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bound_tree.h"
#include "raylab/accelerator/boxed_list.h"
#include "raylab/accelerator/kd_tree.h"
#include "raylab/accelerator/list.h"
#include "raylab/accelerator/octree.h"
#include "raylab/accelerator/wide/wide_tree.h"
#include "raylab/base/error.h"
#include "raylab/scene/needs.h"

#include <array>

namespace raylab {

namespace {

using Made = std::unique_ptr<Accelerator>;

template <class Structure>
Made made(const Scene& scene) {
    return std::make_unique<Structure>(scene);
}

Made bsp(const Scene& scene) { return std::make_unique<KdTree>(scene, spatial_median()); }

struct Named {
    const char* name;
    Made (*make)(const Scene&);
};

constexpr std::array structures{
    Named{"list", made<List>},
    Named{"boxed_list", made<BoxedList>},
    Named{"sphere_tree", made<SphereTree>},
    Named{"aabb_tree", made<AabbTree>},
    Named{"obb_tree", made<ObbTree>},
    Named{"octree", made<Octree>},
    Named{"octree_hash", made<OctreeHash>},
    Named{"octree_seads", made<OctreeSeads>},
    Named{"wide", made<WideTree>},
    Named{"bsp", bsp},
    Named{"kd", made<KdTree>},
};

}  // namespace

std::vector<std::string> accelerator_names() {
    std::vector<std::string> names;
    for (const Named& structure : structures) names.push_back(structure.name);
    names.push_back("auto");
    return names;
}

std::string accelerator_list() {
    std::string list;
    for (const std::string& name : accelerator_names()) list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::unique_ptr<Accelerator> make_accelerator(const std::string& name, const Scene& scene) {
    for (const Named& structure : structures)
        if (structure.name == name) return structure.make(scene);
    if (name != "auto") throw Error("expected an accelerator (" + accelerator_list() + "), found \"" + name + "\"");
    return make_accelerator(suited_accelerator(scene), scene);
}

}  // namespace raylab
