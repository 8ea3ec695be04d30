#pragma once

#include "raylab/report/diagram/diagram.h"
#include "raylab/report/ray_tree/ray_tree_view.h"
#include "raylab/tracer/ray_tree_difference.h"

#include <nlohmann/json_fwd.hpp>

namespace raylab {

/// A tree with what stands above it.
struct TitledTree {
    const RayTree& tree;
    std::string title;
};

/// Both trees side by side, the first node that differs red and thick, with what differs written in it.
Diagram difference_diagram(const TitledTree& got, const TitledTree& expected,
                           const std::optional<RayTreeDifference>& difference, const RayTreeView& view = {});

/// {"same", "place", "got_node", "expected_node", "fields": [{"field", "expected", "got"}]}.
nlohmann::ordered_json to_json(const std::optional<RayTreeDifference>& difference);

}  // namespace raylab
