#include "raylab/report/structure/structure_growth.h"
#include "raylab/report/table.h"

#include <algorithm>
#include <array>
#include <span>

namespace raylab {

std::vector<std::string> growth_header() {
    return {"structure", "scene", "primitives", "rays a second",    "primitive tests",
            "box tests", "steps", "built in",   "bytes a primitive"};
}

std::vector<std::vector<std::string>> growth_rows(const std::vector<StructureCost>& costs) {
    std::vector<std::vector<std::string>> rows;
    for (const StructureCost& cost : costs)
        rows.push_back({cost.structure, cost.family, number_text(static_cast<double>(cost.primitives)),
                        number_text(1e9 / cost.nanoseconds.median), number_text(cost.primitive_tests),
                        number_text(cost.box_tests), number_text(cost.steps), duration_text(1e9 * cost.build_seconds),
                        number_text(cost.bytes)});
    return rows;
}

std::vector<StructureCost> tell_growth(const ChapterRun& run, Page& page, const std::vector<StructureMethod>& methods) {
    struct Told {
        GrowthOf what;
        const char *name, *caption;
    };
    constexpr std::array told{
        Told{GrowthOf::rays_per_second, "growth_rays", "Rays of the camera, one thread; bars: quartiles."},
        Told{GrowthOf::primitive_tests, "growth_tests", "What is tested; no machine changes it."},
        Told{GrowthOf::steps, "growth_steps", "Cells or nodes visited; where there are none (a list), no curve."},
        Told{GrowthOf::build_time, "growth_build", "Building the structure."},
        Told{GrowthOf::bytes, "growth_bytes", "Beyond the mesh's own vertices and indices."}};
    const std::vector<GrowingScenes> families{bumpy_balls(run.sized(5, 3), run.sized<std::size_t>(10'000, 900))};
    const auto costs = structure_costs(methods, families, run.sized(4e6, 2e5),
                                       {.repeats = run.sized(5, 1), .shortest = run.sized(0.002, 0.0)});
    std::vector<Page::Figure> figures;
    const std::size_t shown = run.sized(told.size(), std::size_t{2});  // because gnuplot takes a while for each chart
    for (const auto& [what, name, caption] : std::span(told).first(shown)) {
        const auto files = write_chart(growth_chart(costs, what), run.out, name);
        if (std::ranges::any_of(files, [](const auto& file) { return file.extension() == ".svg"; }))
            figures.push_back({std::string(name) + ".svg", caption});
    }
    page.figures(figures);
    page.table(growth_header(), growth_rows(costs),
               "A ray of the camera costs so much; the scenes are one and the "
               "same ball, ever finer.");
    return costs;
}

}  // namespace raylab
