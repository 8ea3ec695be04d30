#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bvh/bvh.h"
#include "raylab/accelerator/bvh/spatial_splits.h"
#include "raylab/accelerator/bvh8/bvh8.h"
#include "raylab/accelerator/grid/grid.h"
#include "raylab/accelerator/kd8/kd8.h"
#include "raylab/accelerator/list.h"
#include "raylab/accelerator/octree/octree.h"
#include "raylab/accelerator/shape_rows/boxed_list.h"
#include "raylab/accelerator/split_tree/kd_tree.h"
#include "raylab/base/error.h"
#include "raylab/scene/moving.h"
#include "raylab/scene/needs.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>

namespace raylab {

namespace {

using Made = std::unique_ptr<Accelerator>;

template <class Structure>
Made made(const Scene& scene, const BuildOptions&) {
    return std::make_unique<Structure>(scene);
}

Made bsp(const Scene& scene, const BuildOptions&) { return std::make_unique<KdTree>(scene, spatial_median()); }

Made bvh(const Scene& scene, const BuildOptions&) {
    if (anything_moves(scene)) return std::make_unique<MovingBvh>(scene);
    return std::make_unique<BoxBvh>(scene);
}

Made set_bvh_splits(const Scene& scene, const BuildOptions&, double max_duplicates) {
    const SortedPrimitives sorted(scene);
    return std::make_unique<BoxBvh>(sorted, build_tree_with_spatial_splits(sorted, {.max_duplicates = max_duplicates}));
}

Made bvh_splits(const Scene& scene, const BuildOptions& options) {
    return set_bvh_splits(scene, options, SpatialSplits{}.max_duplicates);
}

Made bvh8(const Scene& scene, const BuildOptions& options) {
    return std::make_unique<Bvh8>(scene, Bvh8BuildOptions{.threads = options.threads});
}

Made set_bvh8_splits(const Scene& scene, const BuildOptions& options, double max_duplicates) {
    return std::make_unique<Bvh8>(scene,
                                  Bvh8BuildOptions{.max_duplicates = max_duplicates, .threads = options.threads});
}

Made bvh8_splits(const Scene& scene, const BuildOptions& options) { return set_bvh8_splits(scene, options, 0.3); }

Made made_grid_mailbox(const Scene& scene, const BuildOptions&) {
    return std::make_unique<Grid>(scene, GridOptions{.mailboxes = MailboxKind::ray_id});
}

Made set_grid(const Scene& scene, const BuildOptions&, double density) {
    return std::make_unique<Grid>(scene, GridOptions{.density = density});
}

Made set_grid_mailbox(const Scene& scene, const BuildOptions&, double density) {
    return std::make_unique<Grid>(scene, GridOptions{.density = density, .mailboxes = MailboxKind::ray_id});
}

// The octree as published counts describe it: cells are cut until one primitive is left or the depth is reached, and
// they are filled by boxes.
Made set_octree(const Scene& scene, const BuildOptions&, double depth) {
    return std::make_unique<Octree>(scene, OctreeLimits{.few = 1,
                                                        .depth = static_cast<int>(depth),
                                                        .cut = OctreeLimits::Cut::always,
                                                        .assign = OctreeLimits::Assign::by_box});
}

/// A setting follows the name and a colon, for structures that have one: "grid:10".
struct Named {
    const char* name;
    Made (*make)(const Scene&, const BuildOptions&);
    Made (*make_set)(const Scene&, const BuildOptions&, double setting) = nullptr;
    double smallest = 0, largest = 0;
    const char* meaning = "";  // what the setting means
};

std::optional<Made> made_as_set(const Named& structure, const std::string& name, const Scene& scene,
                                const BuildOptions& options) {
    const std::string stem = std::string(structure.name) + ":";
    if (!structure.make_set || !name.starts_with(stem)) return std::nullopt;
    double setting = 0;
    const char* end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data() + stem.size(), end, setting);
    if (error != std::errc() || rest != end || !(setting >= structure.smallest && setting <= structure.largest))
        throw Error(fmt::format("expected {} and a number from {} to {}, found \"{}\"", stem, structure.smallest,
                                structure.largest, name));
    return structure.make_set(scene, options, setting);
}

constexpr std::array structures{
    Named{"list", made<List>},
    Named{"boxed_list", made<BoxedList>},
    Named{"bvh_sphere", made<SphereBvh>},
    Named{"bvh", bvh},
    Named{"bvh_splits", bvh_splits, set_bvh_splits, 0, 100, "duplicates a primitive at most"},
    Named{"bvh_obb", made<SlabBvh>},
    Named{"grid", made<Grid>, set_grid, 0.001, 1000, "cells a primitive"},
    Named{"grid_mailbox", made_grid_mailbox, set_grid_mailbox, 0.001, 1000, "cells a primitive"},
    Named{"octree", made<Octree>, set_octree, 0, Lattice::bits, "cuts deep"},
    Named{"octree_point", made<OctreePoint>},
    Named{"octree_hash", made<OctreeHash>},
    Named{"octree_seads", made<OctreeSeads>},
    Named{"bvh8", bvh8},
    Named{"bvh8_splits", bvh8_splits, set_bvh8_splits, 0, 10, "duplicates a primitive at most"},
    Named{"bsp", bsp},
    Named{"kd", made<KdTree>},
    Named{"kd8", made<Kd8>},
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
    for (const Named& structure : structures) {
        list += structure.name;
        if (structure.make_set) list += fmt::format(" (or {}:N, N {})", structure.name, structure.meaning);
        list += ", ";
    }
    return list + "auto";
}

std::unique_ptr<Accelerator> make_accelerator(const std::string& name, const Scene& scene,
                                              const BuildOptions& options) {
    for (const Named& structure : structures)
        if (structure.name == name) return structure.make(scene, options);
    for (const Named& structure : structures)
        if (auto made = made_as_set(structure, name, scene, options)) return std::move(*made);
    if (name != "auto") throw Error("expected an accelerator (" + accelerator_list() + "), found \"" + name + "\"");
    return make_accelerator(suited_accelerator(scene), scene, options);
}

}  // namespace raylab
