#include "cases.h"

#include "case_examples.h"
#include "cell_sizes.h"
#include "stadium.h"
#include "textbook_grid.h"
#include "walks.h"

#include "raylab/base/number_text.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/structure/structure_question.h"
#include "raylab/report/structure/wrong_hit.h"
#include "raylab/sampling/random.h"

#include <fmt/format.h>

namespace raylab::grids {

namespace {

using Hits = TextbookOptions::Hits;
using Boxes = TextbookOptions::Mailboxes;

std::string share(double ppm) { return ppm == 0 ? "none" : share_text(ppm / 1e6); }

CaseRow at_least(const std::string& method, const std::string& what, double seen, double smallest) {
    return {method, fmt::format("fails: {} above {}", what, share(smallest)), fmt::format("{}: {}", what, share(seen)),
            seen > smallest};
}

CaseRow none(const std::string& method, const std::string& what, double seen) {
    return {method, fmt::format("holds: {} none", what), fmt::format("{}: {}", what, share(seen)), seen == 0};
}

struct Walks {
    const WalkMethod& method;
    CubeOfCells cube;
    std::size_t rays;
    std::uint64_t seed;
};

CaseRow drifts(const std::string& title, double missed, double smallest, const Walks& walks) {
    CaseRow row = at_least(title, "cells missed", missed, smallest);
    if (const auto lost = first_lost_cell(walks.method, walks.cube, walks.rays, walks.seed))
        row.example = example_of(*lost, walks.cube);
    return row;
}

std::vector<CaseRow> drift(const ChapterRun& run) {
    std::vector<CaseRow> rows;
    const double smallest[] = {0.1, 50, 5000};
    for (int i = 0; const int n : {64, 512, 4096}) {
        for (const WalkMethod& method : walk_methods(run)) {
            const auto rays = static_cast<std::size_t>(run.sized(2'000'000, 200'000) / n);
            const auto errors = walk_errors(method, cube_of_cells(n), rays, run.seed);
            const std::string title = fmt::format("{}, {}: {} cells a side", method.name, method.number, n);
            if (method.name == "yours")
                rows.push_back({title, "nothing: shown, not judged", share(errors.missed), true});
            else if (method.name == "t added" && method.number == "float" && n > 64)
                rows.push_back(drifts(title, errors.missed, smallest[i], {method, cube_of_cells(n), rays, run.seed}));
            else if (method.number == "float")
                rows.push_back({title, "nothing: shown, not judged", "cells missed: " + share(errors.missed), true});
            else
                rows.push_back(none(title, "cells missed", errors.missed));
        }
        ++i;
    }
    return rows;
}

// Large triangles at all angles, each of which crosses many cells.
std::shared_ptr<const Scene> large_triangles(std::uint64_t seed) {
    auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t i = 0; i < 180; ++i) {
        const auto at = [&](std::uint64_t dimension) {
            return cast<float>(2 * random_number({.seed = seed, .pixel = i, .dimension = dimension}) - 1);
        };
        mesh->vertices.push_back({at(0), at(1), at(2)});
        if (i % 3 == 2) mesh->faces.push_back({i - 2, i - 1, i});
    }
    return std::make_shared<const Scene>(mesh_scene(mesh, "large triangles"));
}

std::vector<StructureMethod> mailbox_methods() {
    return {textbook_method("hits of any cell end the walk", {.hits = Hits::anywhere}),
            textbook_method("hits beyond the cell forgotten", {.mailboxes = Boxes::without_hits}),
            textbook_method("one id for a line", {.mailboxes = Boxes::of_pixels})};
}

struct WrongHits {
    double ppm = 0;
    std::optional<CaseExample> first;
};

// Each query is made twice: first for half of the ray, like a shadow ray that ends at a light, and then for all of it.
WrongHits wrong_hits(const Accelerator& structure, const StructureWorkload& workload) {
    const auto truth = make_accelerator("list", *workload.scene);
    Traversal traversal;
    WrongHits wrong;
    for (const Ray& ray : workload.rays) {
        const auto expected = truth->closest(ray, traversal);
        Ray half = ray;
        half.range.max = expected ? cast<float>(expected->t / 2) : 0.5f;
        structure.occluded(half, traversal);
        const auto given = structure.closest(ray, traversal);
        if (given.has_value() == expected.has_value() && (!given || given->primitive == expected->primitive)) continue;
        wrong.ppm += 1e6 / static_cast<double>(workload.rays.size());
        if (!wrong.first) wrong.first = wrong_hit(ray, *workload.scene, RayQuestion::nearest, given);
    }
    return wrong;
}

CaseRow fails_more_than(double ppm, const std::string& method, const WrongHits& wrong) {
    CaseRow row = at_least(method, "wrong hits", wrong.ppm, ppm);
    row.example = wrong.first;
    return row;
}

std::vector<CaseRow> mailbox(const ChapterRun& run) {
    const auto workload =
        incoherent_rays("large triangles", large_triangles(run.seed), run.sized<std::size_t>(50'000, 5'000), run.seed);
    std::vector<CaseRow> rows;
    for (const StructureMethod& method : mailbox_methods())
        rows.push_back(fails_more_than(1000, method.name, wrong_hits(*method.make(*workload.scene), workload)));
    // A ray number that wraps around matters for primitives that are tested once in that many rays: for small ones.
    const auto knot =
        std::make_shared<const Scene>(mesh_scene(std::make_shared<const Mesh>(trefoil_knot(0.5, 4)), "knot"));
    const auto small = incoherent_rays("knot", knot, run.sized<std::size_t>(50'000, 10'000), run.seed);
    const auto of_8_bits = textbook_method("ray ids of 8 bits", {.mailboxes = Boxes::of_8_bits});
    rows.push_back(fails_more_than(100, of_8_bits.name, wrong_hits(*of_8_bits.make(*knot), small)));
    for (const std::string name : {"grid", "grid_mailbox"})
        rows.push_back(none(name, "wrong hits", wrong_hits(*make_accelerator(name, *workload.scene), workload).ppm));
    return rows;
}

std::vector<CaseRow> in_stadium(const ChapterRun& run) {
    const auto scene = std::make_shared<const Scene>(knot_in_stadium(run.sized(6, 4), 50));
    const auto workload = camera_rays("stadium", scene, run.sized<std::size_t>(4'000, 400));
    const double smallest = run.sized(500.0, 100.0);
    std::vector<CaseRow> rows;
    for (const std::string name : {"grid:1", "grid:8"}) {
        const double tests = cost_per_ray(name, workload).tests;
        rows.push_back({name, fmt::format("fails: above {:g} tests a ray", smallest),
                        fmt::format("{:.0f} tests a ray", tests), tests > smallest});
    }
    const double tests = cost_per_ray("bvh", workload).tests;
    rows.push_back({"bvh", "holds: below 20 tests a ray", fmt::format("{:.1f} tests a ray", tests), tests < 20});
    return rows;
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    const auto of = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {{"DDA-DRIFT",
             "The t of the next plane is the last one's and a step, a thousand times over: cells that "
             "a ray passes and a walk does not.",
             of(drift)},
            {"MAILBOX",
             "Things that reach through many cells: hits beyond the cell they are found in, and what is "
             "remembered of them.",
             of(mailbox)},
            {"STADIUM",
             "All detail in a thousandth of the space: cells of one size are too "
             "large for it.",
             of(in_stadium)}};
}

Experiment measure_grid_hits(const ChapterRun& run) {
    const auto knot = std::make_shared<const Scene>(
        mesh_scene(std::make_shared<const Mesh>(trefoil_knot(0.5, run.sized(6, 4))), "knot"));
    const auto rays = run.sized<std::size_t>(10'000, 500);
    std::vector<StructureMethod> methods = structure_methods({"grid", "grid_mailbox", "bvh"});
    methods.push_back(textbook_method("textbook's grid", {}));
    methods.push_back(textbook_method("any cell's hit", {.hits = Hits::anywhere}));
    methods.push_back(textbook_method("hits forgotten", {.mailboxes = Boxes::without_hits}));
    Experiment experiment =
        measure_structures(methods,
                           {camera_rays("knot", knot, rays), incoherent_rays("knot", knot, rays, run.seed),
                            edge_rays("knot", knot, rays, run.seed)},
                           {.repeats = run.sized(5, 1), .shortest = 0});
    experiment.question = "grid_hits";
    experiment.title = "What is the nearest hit, by grids?";
    return experiment;
}

}  // namespace raylab::grids
