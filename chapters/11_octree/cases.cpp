#include "cases.h"

#include "octree_methods.h"
#include "octree_workloads.h"

#include "raylab/report/structure_question.h"

#include <fmt/format.h>

namespace raylab::octrees {

namespace {

// A workload with its truth, asked of one structure after the other.
class Trial {
public:
    explicit Trial(StructureWorkload workload) : workload_(std::move(workload)), truth_(true_answers(workload_)) {}

    CaseRow holds(const StructureMethod& method) const {
        const double wrong = share(method);
        return {row(method), "holds: none wrong", percent(wrong), wrong == 0};
    }
    CaseRow fails(const StructureMethod& method, double least) const {
        const double wrong = share(method);
        return {row(method), "fails: more than " + percent(least) + " wrong", percent(wrong), wrong > least};
    }

private:
    static std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }
    std::string row(const StructureMethod& method) const {
        return method.name + ", " + method.number + ": " + workload_.name;
    }
    double share(const StructureMethod& method) const {
        Traversal traversal;
        const auto answers = answers_of(*method.make(*workload_.scene), workload_, traversal);
        return static_cast<double>(wrong_answers(answers, truth_, workload_.question)) /
               static_cast<double>(answers.size());
    }

    StructureWorkload workload_;
    StructureAnswers truth_;
};

std::size_t rays(const ChapterRun& run) { return run.sized<std::size_t>(20'000, 1'000); }

// Not judged: a student's function is shown, never failed, where cases are hard.
void add_slot(std::vector<CaseRow>& rows, const Trial& trial, const ChapterRun& run) {
    const bool yours = run.slot == ChapterRun::Slot::yours;
    CaseRow row = trial.holds(way(yours ? "yours" : "beyond the face", run));
    if (yours) row = {row.method, "shown", row.observed, true};
    rows.push_back(row);
}

std::vector<CaseRow> split_plane(const ChapterRun& run) {
    const Trial trial(plane_rays(rays(run), run.seed));
    std::vector<CaseRow> rows{trial.fails(way("beyond the face, not held", run), 0.005)};
    add_slot(rows, trial, run);
    for (const auto& method : exact_ways()) rows.push_back(trial.holds(method));
    return rows;
}

std::vector<CaseRow> next_cell(const ChapterRun& run) {
    const Trial near(dust_rays(2, rays(run), run.seed)), far(dust_rays(far_away, rays(run), run.seed));
    std::vector<CaseRow> rows{near.fails(way("half a cell along the ray", run), 0.1),
                              near.fails(way("a fixed step along the ray", run), 0.01),
                              far.fails(way("a small step along the ray", run), 0.1)};
    for (const Trial* trial : {&near, &far}) {
        add_slot(rows, *trial, run);
        for (const auto& method : exact_ways()) rows.push_back(trial->holds(method));
    }
    return rows;
}

std::vector<CaseRow> hit_outside(const ChapterRun& run) {
    const Trial trial(camera_rays("hall", hall(4), rays(run)));
    std::vector<CaseRow> rows{trial.fails(way("ends at any hit", run), 0.0005)};
    for (const auto& method : exact_ways()) rows.push_back(trial.holds(method));
    return rows;
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    const auto of = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {
        {"SPLIT-PLANE",
         "Rays in the planes between cells, through edges and corners of cells, at triangles in those planes.",
         of(split_plane)},
        {"NEXT-CELL",
         "A point a short way on along the ray is past small cells, if the way was not short enough, and in the old "
         "cell "
         "still, if it was lost in rounding.",
         of(next_cell)},
        {"HIT-OUTSIDE",
         "A large triangle is in many cells. Found in the first, it may be hit far behind something in a later one.",
         of(hit_outside)}};
}

}  // namespace raylab::octrees
