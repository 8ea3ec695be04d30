#include "cases.h"

#include "box_tests.h"
#include "trees.h"
#include "void_area.h"

#include "raylab/experiment/structure/structure_question.h"
#include "raylab/report/case_drawings.h"
#include "raylab/report/decision_trial.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace raylab::volumes {

namespace {

using Trial = DecisionTrial<Box, BoxQuery, std::optional<double>>;

Trial trial(const ChapterRun& run, BoxWorkload workload) {
    Truth truth = box_truth(workload, run.threads);
    Trial trial{std::move(workload), box_methods(run), std::move(truth)};
    trial.show_wrong_ones([](const BoxWorkload& all, const BoxQuery& query, TrueAnswer answer) {
        return example_of(query.ray, all.data[query.box], answer);
    });
    return trial;
}

Trial trial(const ChapterRun& run, const std::string& name) {
    for (auto& workload : box_workloads(run.sized<std::size_t>(100'000, 5'000), run.seed))
        if (workload.name == name) return trial(run, std::move(workload));
    assert(!"a workload with this name");
    std::abort();
}

// A row that expects no missed box; a box that is visited in vain only costs time.
CaseRow never_missed(const Trial& trial, const std::string& title) {
    const WrongDecisions found = trial.wrong(title);
    return {row_title(title, trial.workload().name), "holds: no box missed that is hit", in_words(found),
            found.misses == 0};
}

const std::vector<std::string> conservative{"padded, float", "padded, four at once, float",
                                            "padded, two at once, double"};

std::vector<CaseRow> slot_row(const ChapterRun& run, const Trial& trial) {
    if (run.is_yours("box_entry")) return {trial.shown(box_methods(run).back())};
    return {};
}

std::vector<CaseRow> nan(const ChapterRun& run) {
    const Trial plane = trial(run, "in a plane"), flat = trial(run, "flat boxes");
    std::vector<CaseRow> rows{plane.more_missed_than(0.99, "fmin and fmax, float"),
                              plane.more_missed_than(0.2, "std::min and max, float")};
    for (const Trial* one : {&plane, &flat}) {
        rows.push_back(never_missed(*one, "ordered, float"));
        for (const std::string& title : conservative) rows.push_back(never_missed(*one, title));
        for (CaseRow& row : slot_row(run, *one)) rows.push_back(std::move(row));
    }
    if (!run.is_yours("box_entry")) rows.push_back(plane.never_wrong("divided, double"));
    return rows;
}

// Entry and exit may need three units together, and (6) widens by two: a ray found by a search for such a one.
BoxWorkload made_ray() {
    const Ray ray{{-0.0398084521f, -0.036929667f, 0}, {0.937523782f, 0.934928179f, 0}};
    return {"a made ray", "", {{{1, -8, -8}, {8, 1, 8}}}, {{ray, 0}}};
}

std::vector<CaseRow> pad(const ChapterRun& run) {
    const Trial near = trial(run, "at corners"), far = trial(run, "at corners, far");
    std::vector<CaseRow> rows{
        near.more_missed_than(0.01, "ordered, float"), near.more_missed_than(0.01, "products, float"),
        far.more_missed_than(0.01, "ordered, float"), far.more_missed_than(0.05, "products, float"),
        far.more_missed_than(0.0001, "ordered, double")};
    for (const Trial* one : {&near, &far}) {
        for (const std::string& title : conservative) rows.push_back(never_missed(*one, title));
        for (CaseRow& row : slot_row(run, *one)) rows.push_back(std::move(row));
    }
    const Trial made = trial(run, made_ray());
    rows.push_back(made.more_missed_than(0.99, conservative[0]));
    rows.push_back(never_missed(made, conservative[1]));
    rows.push_back(never_missed(made, conservative[2]));
    return rows;
}

CaseRow void_row(const std::string& what, double measured, double truth) {
    return {what, fmt::format("holds: {:.2f} %, within one", 100 * truth), fmt::format("{:.2f} %", 100 * measured),
            std::abs(measured - truth) < 0.01};
}

// Cauchy 1832: averaged over all directions, the projected area of a convex body is a quarter of its surface.
std::vector<CaseRow> void_area(const ChapterRun& run) {
    const auto seen = [&](Shape shape) {
        return seen_areas({.shape = std::move(shape)}, run.sized<std::size_t>(200'000, 30'000), run.seed);
    };
    constexpr double pi = 3.14159265358979;
    const SeenAreas ball = seen(Sphere{{1, 2, 3}, 0.5f});
    const Polygon square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
    const SeenAreas wall = seen(square), rod = seen(Cylinder{{-1, -1, -1}, {1, 1, 1}, 0.02f, Ends::capped});
    return {void_row("a ball in its box", ball.empty(ball.box), 1 - pi / 6),
            void_row("a ball in its sphere", ball.empty(ball.sphere), 0),
            void_row("a square in its sphere", wall.empty(wall.sphere), 1 - 1 / pi),
            void_row("a square in its box", wall.empty(wall.box), 0),
            {"a slanted rod in its box", "fails: more than 90 % void",
             fmt::format("{:.1f} %", 100 * rod.empty(rod.box)), rod.empty(rod.box) > 0.9},
            {"a slanted rod in an oriented box", "holds: less than 35 % void",
             fmt::format("{:.1f} %", 100 * rod.empty(rod.oriented_box)), rod.empty(rod.oriented_box) < 0.35}};
}

// The city around a ray from above.
CaseExample lost_pixel(const StructureWorkload& workload, std::size_t pixel) {
    const Ray& ray = workload.rays[pixel];
    const Mesh& mesh = *std::get<std::shared_ptr<const Mesh>>(workload.scene->objects.front().shape);
    constexpr float reach = 2.5;  // metres
    const auto is_near = [&](const Vec3f& corner) {
        return std::abs(corner.x - ray.origin.x) < reach && std::abs(corner.y - ray.origin.y) < reach;
    };
    std::vector<TriangleOf<double>> shown;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const Triangle one = mesh.triangle(face);
        if (is_near(one.a) && is_near(one.b) && is_near(one.c)) shown.push_back(in<double>(one));
    }
    return {in_words(ray), seen_along(in<double>(ray), shown, "In truth it hits the wall below it.")};
}

std::vector<CaseRow> holes(const ChapterRun& run) {
    const auto workload = city_rays(run.sized(256, 64));
    const auto truth = true_answers(workload);
    const auto row = [&](const StructureMethod& method, const std::string& expected) {
        Traversal traversal;
        const auto answers = answers_of(*method.make(*workload.scene), workload, traversal);
        const double wrong =
            static_cast<double>(wrong_answers(answers, truth, workload.question)) / static_cast<double>(answers.size());
        CaseRow made{method.name, expected, share_text(wrong) + " wrong"};
        made.as_expected = expectation_of(made) == Expectation::fails ? wrong > 0.01 : wrong == 0;
        for (std::size_t k = 0; k < answers.size() && !made.example; ++k) {
            const std::size_t i = (answers.size() / 2 + k) % answers.size();  // from the middle of the picture on
            if (truth[i] && !answers[i]) made.example = lost_pixel(workload, i);
        }
        return made;
    };
    std::vector<CaseRow> rows;
    const auto weak = weak_trees();
    for (std::size_t i = 0; i < 2; ++i) rows.push_back(row(weak[i], "fails: more than 1 % of the pixels wrong"));
    for (const auto& method : trees()) rows.push_back(row(method, "holds: none wrong"));
    return rows;
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    const auto of = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {{"SLAB-NAN",
             "A ray in the plane of a face, along it: 0 * infinity is no number, and goes its own way "
             "through min and max.",
             of(nan)},
            {"SLAB-PAD",
             "Rays at the corners of boxes, near the origin and a thousand kilometres away: a slab's "
             "ends are rounded. One ray is made so that two units are too little.",
             of(pad)},
            {"VOID-AREA", "What bounds let pass in vain, against closed forms.", of(void_area)},
            {"HOLES", "Towers on whole metres from above, by trees whose box test takes no care of NaN.", of(holes)}};
}

}  // namespace raylab::volumes
