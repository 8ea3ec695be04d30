#include "raylab/experiment/structure/structure_question.h"

#include "raylab/scene/needs.h"

#include <algorithm>
#include <cassert>

namespace raylab {

namespace {

std::optional<Hit> answer(const Accelerator& structure, const Ray& ray, RayQuestion question, Traversal& traversal) {
    if (question == RayQuestion::nearest) return structure.closest(ray, traversal);
    return structure.occluded(ray, traversal) ? std::optional(Hit{}) : std::nullopt;
}

std::map<std::string, double> counts_of(const Accelerator& structure, const StructureWorkload& workload,
                                        const Traversal& counted) {
    const double rays = static_cast<double>(std::max<std::size_t>(1, workload.rays.size()));
    const double primitives = static_cast<double>(std::max<std::size_t>(1, primitive_count(*workload.scene)));
    return {{"primitive tests", static_cast<double>(counted.primitive_tests) / rays},
            {"box tests", static_cast<double>(counted.box_tests) / rays},
            {"steps", static_cast<double>(counted.steps) / rays},
            {"exact decisions", static_cast<double>(counted.exact_decisions) / rays},
            {"bytes a primitive", static_cast<double>(structure.bytes()) / primitives}};
}

}  // namespace

bool same_answer(const std::optional<Hit>& a, const std::optional<Hit>& b, RayQuestion question) {
    if (!a || !b || question == RayQuestion::any) return a.has_value() == b.has_value();
    return a->primitive == b->primitive && a->t == b->t;
}

StructureAnswers answers_of(const Accelerator& structure, const StructureWorkload& workload, Traversal& traversal) {
    StructureAnswers answers;
    answers.reserve(workload.rays.size());
    for (const Ray& ray : workload.rays) answers.push_back(answer(structure, ray, workload.question, traversal));
    return answers;
}

std::size_t wrong_answers(const StructureAnswers& answers, const StructureAnswers& truth, RayQuestion question) {
    assert(answers.size() == truth.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) wrong += !same_answer(answers[i], truth[i], question);
    return wrong;
}

StructureAnswers true_answers(const StructureWorkload& workload) {
    Traversal traversal;
    return answers_of(*make_accelerator("list", *workload.scene), workload, traversal);
}

Measurement measure_structure(const StructureMethod& method, const StructureWorkload& workload,
                              const StructureAnswers& truth, const MeasureOptions& options) {
    const std::size_t rays = workload.rays.size();
    std::unique_ptr<Accelerator> structure;
    Measurement row{.method = method.name, .number = method.number, .workload = workload.name, .queries = rays};
    row.prepare_nanoseconds = time_per_query(
        1, [&] { structure = method.make(*workload.scene); }, options);
    row.nanoseconds = time_per_query(
        rays,
        [&] {
            Traversal uncounted;
            for (const Ray& ray : workload.rays) answer(*structure, ray, workload.question, uncounted);
        },
        options.with(MeasureOptions::Clock::thread));  // queries run in one thread; builds may use several
    Traversal counted;
    const auto answers = answers_of(*structure, workload, counted);
    const double million = 1e6 / static_cast<double>(std::max<std::size_t>(1, rays));
    row.error = static_cast<double>(wrong_answers(answers, truth, workload.question)) * million;
    row.error_bound = 3 * million;
    row.counts = counts_of(*structure, workload, counted);
    return row;
}

Experiment measure_structures(const std::vector<StructureMethod>& methods,
                              const std::vector<StructureWorkload>& workloads, const MeasureOptions& options) {
    Experiment experiment{.question = "nearest_hit",
                          .title = "What does a ray hit first?",
                          .error_axis = "wrong answers [ppm]",
                          .rows = {}};
    for (const StructureWorkload& workload : workloads) {
        const auto truth = true_answers(workload);
        for (const StructureMethod& method : methods)
            experiment.rows.push_back(measure_structure(method, workload, truth, options));
    }
    return experiment;
}

}  // namespace raylab
