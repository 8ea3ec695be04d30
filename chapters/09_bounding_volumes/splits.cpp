#include "splits.h"

#include "other_trees.h"

#include "raylab/accelerator/bvh/box_tree.h"
#include "raylab/report/structure/structure_growth.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::volumes {

namespace {

/// The cost of a tree: to build, to keep, and for the two kinds of rays.
struct SplitCost {
    std::string scene, tree;
    StructureCost camera, incoherent;
};

std::vector<StructureCost> costs(const StructureMethod& method, const std::vector<StructureWorkload>& workloads) {
    // No limit, however expensive a ray is, so that trees are compared on the same rays.
    constexpr double ask_all = 1e12;
    return structure_costs({method}, {{"", workloads}}, ask_all, {.repeats = 1, .shortest = 0});
}

// The work of a ray: a test of a bound counts a quarter of a triangle's, as in the builder.
double work(const StructureCost& cost) { return cost.primitive_tests + box_visit_cost / 2 * cost.box_tests; }

std::vector<SplitCost> split_costs(std::span<const SplitScene> scenes) {
    auto methods = cuts();
    methods.erase(methods.begin());  // the one split at the median
    methods.push_back({"by cost, planes too", "exact", structure_method("bvh_splits").make});
    std::vector<SplitCost> found;
    for (const SplitScene& scene : scenes)
        for (const StructureMethod& method : methods) {
            const auto both = costs(method, {scene.camera, scene.incoherent});
            found.push_back({scene.name, method.name, both[0], both[1]});
        }
    return found;
}

std::vector<std::vector<std::string>> counted_rows(const std::vector<SplitCost>& costs) {
    std::vector<std::vector<std::string>> rows;
    const auto number = [](double x) { return fmt::format("{:.1f}", x); };
    for (const auto& [scene, tree, camera, incoherent] : costs)
        rows.push_back({scene, tree, number(camera.primitive_tests), number(camera.box_tests),
                        number(incoherent.primitive_tests), number(incoherent.box_tests),
                        fmt::format("{:.0f}", camera.bytes)});
    return rows;
}

}  // namespace

std::vector<std::string> splits_header() {
    return {"scene",           "tree", "tests, camera", "bounds, camera", "tests, incoherent", "bounds, incoherent",
            "bytes a triangle"};
}

std::vector<std::vector<std::string>> splits_rows(std::span<const SplitScene> scenes) {
    return counted_rows(split_costs(scenes));
}

CurveChart splits_chart(std::span<const SplitScene> scenes) {
    CurveChart chart{.title = "What duplicates buy",
                     .x_label = "bytes a triangle",
                     .y_label = "work a ray, of that without",
                     .curves = {}};
    for (const SplitScene& scene : scenes) {
        Curve curve{.name = scene.name, .x = {}, .y = {}};
        double without = 0;
        for (const double largest : {0.0, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0}) {
            const StructureCost found =
                costs(structure_method(fmt::format("bvh_splits:{:g}", largest)), {scene.incoherent})[0];
            if (largest == 0) without = work(found);
            curve.x.push_back(found.bytes);
            curve.y.push_back(work(found) / without);
        }
        chart.curves.push_back(curve);
    }
    return chart;
}

}  // namespace raylab::volumes
