#pragma once

#include "raylab/report/diagram/diagram.h"
#include "raylab/report/ray_tree/ray_tree_difference.h"
#include "raylab/report/ray_tree/ray_tree_view.h"

#include <nlohmann/json_fwd.hpp>

namespace raylab {

/// A tree with a title.
struct TitledTree {
    const RayTree& tree;
    std::string title;
};

/// Draws both trees side by side. The first node that differs is red and thick and lists the differences.
Diagram difference_diagram(const TitledTree& got, const TitledTree& expected,
                           const std::optional<RayTreeDifference>& difference, const RayTreeView& view = {});

/// The difference as JSON: {"same", "place", "got_node", "expected_node", "fields": [{"field", "expected", "got"}]}.
nlohmann::ordered_json to_json(const std::optional<RayTreeDifference>& difference);

}  // namespace raylab
