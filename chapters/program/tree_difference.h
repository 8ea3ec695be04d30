#pragma once

#include "raylab/base/outputs.h"
#include "raylab/base/program.h"
#include "raylab/report/ray_tree/ray_tree_view.h"

#include <optional>
#include <string>

namespace raylab {

/// Two ray trees to be compared.
struct ComparedTrees {
    RayTree got;
    std::string got_title;
    RayTree expected;
    std::string expected_title;
    RayTreeView view;
};

/// Reports where the trees differ, draws them side by side where `output` says so, and writes the difference as JSON.
ExitCode report_difference(const ComparedTrees& trees, const std::optional<std::string>& output,
                           const std::optional<std::string>& json, Outputs& outputs);

}  // namespace raylab
