#include "cases.h"

#include "painting.h"
#include "questions.h"

#include "raylab/report/structure/structure_trial.h"

#include <fmt/format.h>

namespace raylab::split {

namespace {

StructureMethod weak(const std::string& name) {
    for (StructureMethod& method : weak_trees())
        if (method.name == name) return method;
    throw std::logic_error("a weak tree with this name");
}

void add_strong(std::vector<CaseRow>& rows, const StructureTrial& trial) {
    for (const StructureMethod& method : strong_trees()) rows.push_back(trial.never_wrong(method));
}

std::size_t rays(const ChapterRun& run) { return run.sized<std::size_t>(20'000, 1'000); }

std::vector<CaseRow> split_plane(const ChapterRun& run) {
    const StructureTrial ball(in_planes("bumps", bumps(run), rays(run), run.seed)),
        floor(in_planes("tiles", tiles(), rays(run), run.seed));
    std::vector<CaseRow> rows{
        ball.shown(weak("kd, NaN to the far side")), floor.more_wrong_than(0.001, weak("kd, NaN to the far side")),
        floor.more_wrong_than(0.001, weak("kd, hits only inside the cell")), ball.shown(weak("kd, rounded planes")),
        floor.more_wrong_than(0.001, weak("kd, rounded planes"))};
    add_strong(rows, ball);
    add_strong(rows, floor);
    return rows;
}

std::vector<CaseRow> beyond_cell(const ChapterRun& run) {
    const StructureTrial trial(balls(rays(run), run.seed));
    std::vector<CaseRow> rows{trial.more_wrong_than(0.001, weak("kd, first cell with a hit")),
                              trial.shown(weak("kd, hits only inside the cell"))};
    add_strong(rows, trial);
    return rows;
}

std::vector<CaseRow> painter(const ChapterRun& run) {
    const auto pixels = [](std::size_t count) {
        return count == 0 ? std::string("every one") : fmt::format("{} are not", count);
    };
    std::vector<CaseRow> rows;
    for (const Scene& scene : {beams(), knot(run.sized(320, 96))}) {
        const PaintersTree tree(scene);
        const std::size_t by_distance = wrong_pixels(scene, paint_by_distance(tree, frame_of(scene)));
        const std::size_t by_tree = wrong_pixels(scene, paint(tree, frame_of(scene)));
        const bool must_fail = scene.source == "beams";  // small triangles seldom show it
        rows.push_back({"painted by distance: " + scene.source,
                        must_fail ? "fails: pixels show what is hidden" : "nothing: shown, not judged",
                        pixels(by_distance), !must_fail || by_distance > 0});
        rows.push_back({"painted by the tree: " + scene.source, "holds: every pixel is the ray tracer's",
                        pixels(by_tree), by_tree == 0});
    }
    return rows;
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    return {
        {"SPLIT-PLANE",
         "Rays start in the planes that cut the cells and mostly stay in them: 0 / 0 says nothing about the side. The "
         "tiles lie in such planes themselves.",
         [run] { return split_plane(run); }},
        {"BEYOND-CELL",
         "A ball is in every cell that its box overlaps, and hit in another; a nearer one may lie between.",
         [run] { return beyond_cell(run); }},
        {"PAINTER", "Three beams overlap in a ring: no order of whole triangles is right. A knot hides itself.",
         [run] { return painter(run); }}};
}

}  // namespace raylab::split
