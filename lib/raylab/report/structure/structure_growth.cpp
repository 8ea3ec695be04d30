#include "raylab/report/structure/structure_growth.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/structure/structure_question.h"
#include "raylab/scene/needs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace raylab {

namespace {

double work_of(const Traversal& counted) {
    return static_cast<double>(counted.primitive_tests) + static_cast<double>(counted.box_tests) +
           static_cast<double>(counted.steps);
}

// Some of the rays, spread over all of them, so that they cost about `max_work`. Counts decide and not times, so the
// choice is the same in every run and on every machine.
StructureWorkload affordable(const Accelerator& structure, const StructureWorkload& workload, double max_work) {
    constexpr std::size_t tried = 16;
    const auto spread = [&](std::size_t count) {
        StructureWorkload some = workload;
        some.rays.clear();
        for (std::size_t i = 0; i < count; ++i) some.rays.push_back(workload.rays[i * workload.rays.size() / count]);
        return some;
    };
    if (workload.rays.size() <= tried) return workload;
    Traversal counted;
    answers_of(structure, spread(tried), counted);
    const double each = std::max(1.0, work_of(counted) / tried);
    const auto count = static_cast<std::size_t>(std::max(static_cast<double>(tried), max_work / each));
    return count < workload.rays.size() ? spread(count) : workload;
}

/// A structure, and the time to build it: the shortest of several builds where they are short.
struct Built {
    std::unique_ptr<Accelerator> structure;
    double seconds = std::numeric_limits<double>::infinity();
};

Built built(const StructureMethod& method, const Scene& scene) {
    Built result;
    for (int times = 0; times < 3 && (times == 0 || result.seconds < 0.02); ++times) {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t processor_start = std::clock();
        result.structure = method.make(scene);
        // 1: the step of its clock.
        const double processor = static_cast<double>(1 + std::clock() - processor_start) / CLOCKS_PER_SEC;
        const double waited = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        // The processor time of one thread does not depend on other processes; for several threads the elapsed time
        // counts, which is then the smaller one.
        result.seconds = std::min({result.seconds, waited, processor});
    }
    return result;
}

StructureCost cost_of(const StructureMethod& method, const std::string& family, const StructureWorkload& workload,
                      double max_work, const MeasureOptions& options) {
    const Scene& scene = *workload.scene;
    const std::size_t primitives = std::max<std::size_t>(1, primitive_count(scene));
    const auto [structure, build_seconds] = built(method, scene);
    const StructureWorkload asked = affordable(*structure, workload, max_work);
    Traversal counted;
    answers_of(*structure, asked, counted);
    const double rays = static_cast<double>(std::max<std::size_t>(1, asked.rays.size()));
    const auto ask = [&] {
        Traversal uncounted;
        answers_of(*structure, asked, uncounted);
    };
    return {.structure = method.name + (method.number == "exact" ? "" : ", " + method.number),
            .family = family,
            .primitives = primitives,
            .rays = asked.rays.size(),
            .build_seconds = build_seconds,
            .bytes = static_cast<double>(structure->bytes()) / static_cast<double>(primitives),
            .nanoseconds = time_per_query(asked.rays.size(), ask, options.with(MeasureOptions::Clock::thread)),
            .primitive_tests = static_cast<double>(counted.primitive_tests) / rays,
            .box_tests = static_cast<double>(counted.box_tests) / rays,
            .steps = static_cast<double>(counted.steps) / rays};
}

struct Shown {
    std::string title, y_label;
    double value, low, high;
};

Shown shown(const StructureCost& cost, GrowthOf what) {
    const auto plain = [](const std::string& title, const std::string& label, double value) {
        return Shown{title, label, value, value, value};
    };
    switch (what) {
        case GrowthOf::rays_per_second:
            return {"Rays a second", "rays a second, one thread", 1e9 / cost.nanoseconds.median,
                    1e9 / cost.nanoseconds.high, 1e9 / cost.nanoseconds.low};
        case GrowthOf::primitive_tests:
            return plain("Primitives tested", "primitive tests a ray", cost.primitive_tests);
        case GrowthOf::box_tests:
            return plain("Bounds tested", "box tests a ray", cost.box_tests);
        case GrowthOf::steps:
            return plain("Cells and nodes visited", "steps a ray", cost.steps);
        case GrowthOf::build_time:
            return plain("Time to build", "seconds", cost.build_seconds);
        case GrowthOf::bytes:
            break;
    }
    return plain("Memory", "bytes a primitive", cost.bytes);
}

}  // namespace

GrowingScenes bumpy_balls(int levels, std::size_t rays) {
    GrowingScenes balls{"bumpy ball", {}};
    for (int level = 2; level < 2 + levels; ++level) {
        const auto mesh = std::make_shared<const Mesh>(bumpy_sphere(level));
        balls.workloads.push_back(
            camera_rays("bumpy ball", std::make_shared<const Scene>(mesh_scene(mesh, "bumpy ball")), rays));
    }
    return balls;
}

std::vector<StructureCost> structure_costs(const std::vector<StructureMethod>& methods,
                                           const std::vector<GrowingScenes>& scenes, double max_work,
                                           const MeasureOptions& options) {
    std::vector<StructureCost> costs;
    for (const StructureMethod& method : methods)
        for (const auto& [family, workloads] : scenes)
            for (const StructureWorkload& workload : workloads)
                costs.push_back(cost_of(method, family, workload, max_work, options));
    return costs;
}

std::vector<StructureCost> growth_counts(const ChapterRun& run, const std::vector<StructureMethod>& methods) {
    return structure_costs(methods, {bumpy_balls(run.sized(5, 3), run.sized<std::size_t>(10'000, 900))},
                           run.sized(4e6, 2e5), {.repeats = 1, .shortest = 0});
}

CurveChart growth_chart(const std::vector<StructureCost>& costs, GrowthOf what) {
    CurveChart chart{.x_label = "primitives",
                     .x_axis = AxisKind::logarithmic,
                     .y_axis = AxisKind::logarithmic,
                     .curves = {},
                     .size = CurveChart::Size::half};
    const bool one_family =
        std::ranges::all_of(costs, [&](const auto& cost) { return cost.family == costs.front().family; });
    for (const StructureCost& cost : costs) {
        const std::string name = cost.structure + (one_family ? "" : ", " + cost.family);
        const auto [title, y_label, value, low, high] = shown(cost, what);
        if (chart.curves.empty() || chart.curves.back().name != name)
            chart.curves.push_back({.name = name, .x = {}, .y = {}, .look = chart.curves.size()});
        chart.title = title;
        chart.y_label = y_label;
        Curve& curve = chart.curves.back();
        curve.x.push_back(static_cast<double>(cost.primitives));
        curve.y.push_back(value);
        if (what != GrowthOf::rays_per_second) continue;
        curve.low.push_back(low);
        curve.high.push_back(high);
    }
    const auto is_nothing = [](const Curve& curve) {
        return std::ranges::all_of(curve.y, [](double y) { return !(y > 0); });
    };
    // A list has no steps. The others look as in the charts beside this one.
    std::erase_if(chart.curves, is_nothing);
    return chart;
}

}  // namespace raylab
