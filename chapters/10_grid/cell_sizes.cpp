#include "cell_sizes.h"

#include "grid_facts.h"
#include "stadium.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/structure/structure_question.h"
#include "raylab/report/table.h"
#include "raylab/sampling/random.h"
#include "raylab/scene/needs.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace raylab::grids {

namespace {

constexpr float ball_radius = 0.3f;  // of one ball in a cube of side 2; of n balls the cube root of n smaller

// Small spheres at random places in a cube, the ideal scene for grids.
Scene even_balls(int count, std::uint64_t seed) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
        const auto at = [&](std::uint64_t dimension) {
            return cast<float>(
                2 * random_number({.seed = seed, .pixel = static_cast<std::uint64_t>(i), .dimension = dimension}) - 1);
        };
        scene.objects.push_back(
            {.shape = Sphere{{at(0), at(1), at(2)}, ball_radius / std::cbrt(static_cast<float>(count))},
             .placement = {}});
    }
    look_at_all(scene);
    return scene;
}

DensitySweep swept(const std::string& name, const std::shared_ptr<const Scene>& scene, const ChapterRun& run) {
    const auto workload = camera_rays(name, scene, run.sized<std::size_t>(2'500, 400));
    DensitySweep sweep{name, {0.1, 0.3, 1, 3, 10, 30, 100}, {}};
    for (const double density : sweep.densities)
        sweep.costs.push_back(cost_per_ray(fmt::format("grid:{:g}", density), workload));
    return sweep;
}

}  // namespace

CostPerRay cost_per_ray(const std::string& accelerator, const StructureWorkload& workload) {
    Traversal traversal;
    const auto structure = make_accelerator(accelerator, *workload.scene);
    answers_of(*structure, workload, traversal);
    const auto rays = static_cast<double>(workload.rays.size());
    return {static_cast<double>(traversal.primitive_tests) / rays, static_cast<double>(traversal.box_tests) / rays,
            static_cast<double>(traversal.steps) / rays,
            static_cast<double>(structure->bytes()) / static_cast<double>(primitive_count(*workload.scene))};
}

std::shared_ptr<const Scene> knot(const ChapterRun& run) {
    return std::make_shared<const Scene>(
        mesh_scene(std::make_shared<const Mesh>(trefoil_knot(0.5, run.sized(6, 4))), "knot"));
}

std::vector<DensitySweep> density_sweeps(const ChapterRun& run) {
    return {swept("even balls", std::make_shared<const Scene>(even_balls(run.sized(8000, 500), run.seed)), run),
            swept("knot", knot(run), run), swept("knot in a stadium", stadium_scene(run), run)};
}

CurveChart density_chart(const std::vector<DensitySweep>& sweeps, const std::string& label, double CostPerRay::*cost) {
    CurveChart chart{.title = label,
                     .x_label = "cells a primitive",
                     .y_label = label,
                     .x_axis = AxisKind::logarithmic,
                     .y_axis = AxisKind::logarithmic,
                     .curves = {},
                     .size = CurveChart::Size::half};
    for (const DensitySweep& sweep : sweeps) {
        Curve curve{.name = sweep.scene, .x = sweep.densities, .y = {}};
        for (const CostPerRay& each : sweep.costs) curve.y.push_back(each.*cost);
        chart.curves.push_back(curve);
    }
    return chart;
}

std::vector<std::string> density_header() { return {"cells a primitive", "even balls", "knot", "knot in a stadium"}; }

std::vector<std::vector<std::string>> density_rows(const std::vector<DensitySweep>& sweeps) {
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < sweeps[0].densities.size(); ++i) {
        rows.push_back({number_text(sweeps[0].densities[i])});
        for (const DensitySweep& sweep : sweeps)
            rows.back().push_back(number_text(sweep.costs[i].tests) + " / " + number_text(sweep.costs[i].steps));
    }
    return rows;
}

std::vector<std::string> list_length_header() { return {"cells a primitive", "tests a cell, counted", "by (6)"}; }

std::vector<std::vector<std::string>> list_length_rows(const DensitySweep& even_balls) {
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < even_balls.densities.size(); ++i) {
        const double density = even_balls.densities[i], q = ball_radius / 2 * std::cbrt(density);
        const double expected =
            (1 + 6 * q + 3 * std::numbers::pi * q * q + 4 * std::numbers::pi / 3 * q * q * q) / density;
        const CostPerRay& cost = even_balls.costs[i];
        rows.push_back({number_text(density), number_text(cost.tests / cost.steps), number_text(expected)});
    }
    return rows;
}

std::vector<std::string> mailbox_header() {
    return {"cells a primitive", "no mailboxes", "id of the ray", "cache of eight"};
}

std::vector<std::vector<std::string>> mailbox_rows(const ChapterRun& run) {
    const auto workload = incoherent_rays("knot", knot(run), run.sized<std::size_t>(4'000, 400), run.seed);
    std::vector<std::vector<std::string>> rows;
    for (const double density : {1.0, 8.0, 64.0}) {
        rows.push_back({number_text(density)});
        for (const StructureMethod& method :
             {structure_method(fmt::format("grid:{:g}", density)),
              structure_method(fmt::format("grid_mailbox:{:g}", density)), cached_grid(density)}) {
            Traversal traversal;
            answers_of(*method.make(*workload.scene), workload, traversal);
            rows.back().push_back(number_text(static_cast<double>(traversal.primitive_tests) /
                                              static_cast<double>(workload.rays.size())));
        }
    }
    return rows;
}

}  // namespace raylab::grids
