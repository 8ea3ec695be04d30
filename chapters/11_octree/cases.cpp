#include "cases.h"

#include "octree_methods.h"
#include "octree_workloads.h"

#include "raylab/report/structure/structure_trial.h"

namespace raylab::octrees {

namespace {

std::size_t rays(const ChapterRun& run) { return run.sized<std::size_t>(20'000, 1'000); }

// A student's function is shown in hard cases, but nothing is expected of it.
CaseRow slot_row(const StructureTrial& trial, const ChapterRun& run) {
    if (run.is_yours("point_in_next_cell")) return trial.shown(way("yours", run));
    return trial.never_wrong(way("beyond the face", run));
}

std::vector<CaseRow> split_plane(const ChapterRun& run) {
    const StructureTrial trial(plane_rays(rays(run), run.seed));
    std::vector<CaseRow> rows{trial.more_wrong_than(0.005, way("beyond the face, not held", run))};
    rows.push_back(slot_row(trial, run));
    for (const auto& method : exact_ways()) rows.push_back(trial.never_wrong(method));
    return rows;
}

std::vector<CaseRow> next_cell(const ChapterRun& run) {
    const StructureTrial near(dust_rays(2, rays(run), run.seed)), far(dust_rays(far_away, rays(run), run.seed));
    std::vector<CaseRow> rows{near.more_wrong_than(0.1, way("half a cell along the ray", run)),
                              near.more_wrong_than(0.01, way("a fixed step along the ray", run)),
                              far.more_wrong_than(0.1, way("a small step along the ray", run))};
    for (const StructureTrial* trial : {&near, &far}) {
        rows.push_back(slot_row(*trial, run));
        for (const auto& method : exact_ways()) rows.push_back(trial->never_wrong(method));
    }
    return rows;
}

std::vector<CaseRow> hit_outside(const ChapterRun& run) {
    const StructureTrial trial(camera_rays("hall", hall(4), rays(run)));
    std::vector<CaseRow> rows{trial.more_wrong_than(0.0005, way("ends at any hit", run))};
    for (const auto& method : exact_ways()) rows.push_back(trial.never_wrong(method));
    return rows;
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    const auto of = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {
        {"CELL-FACE",
         "Rays in the planes between cells, through edges and corners of cells, at triangles in those planes.",
         of(split_plane)},
        {"NEXT-CELL",
         "A point a short way on along the ray is past small cells, if the way was not short enough, and in the old "
         "cell still, if it was lost in rounding.",
         of(next_cell)},
        {"HIT-OUTSIDE",
         "A large triangle is in many cells. Found in the first, it may be hit far behind something in a later one.",
         of(hit_outside)}};
}

}  // namespace raylab::octrees
