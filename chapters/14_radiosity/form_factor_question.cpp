#include "form_factor_question.h"

#include "squares.h"

#include "raylab/radiosity/form_factor/form_factor_methods.h"
#include "raylab/radiosity/form_factor/polygon_form_factor.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace raylab::cornell {

namespace {

struct Pair {
    std::string name;
    Quadrilateral from, to;
};

std::vector<Pair> pairs() {
    return {{"squares 5 apart", lower_square(), upper_square(5)},
            {"squares 0.5 apart", lower_square(), upper_square(0.5)},
            {"squares that share an edge", lower_square(), leaning_square(std::numbers::pi / 2)}};
}

// The most time that one answer may take on a chart that is made while one waits.
constexpr int most_effort_in_quick_run = 64;

}  // namespace

Experiment measure_form_factors(const ChapterRun& run) {
    Experiment experiment{.question = "form_factors",
                          .title = "How much of a square's light arrives at another?",
                          .error_axis = "relative error",
                          .rows = {}};
    for (const Pair& pair : pairs()) {
        const double truth = polygon_form_factor(pair.from, pair.to);
        for (const FormFactorMethod& method : form_factor_methods())
            for (const int effort : method.efforts) {
                if (run.effort == ChapterRun::Effort::quick && effort > most_effort_in_quick_run) continue;
                const auto answer = [&] { return method.answer(pair.from, pair.to, effort); };
                const auto value = answer();
                if (!value) continue;
                experiment.rows.push_back(
                    {.method = method.name,
                     .number = "double",
                     .workload = pair.name,
                     .knob = method.effort.empty() ? "" : fmt::format("{} {}", effort, method.effort),
                     .source = method.source,
                     .error = std::abs(value->value / truth - 1),
                     .error_bound = 1e-13,
                     .nanoseconds = time_per_query(
                         1, [&] { answer(); }, run.timing()),
                     .queries = 1});
            }
    }
    return experiment;
}

}  // namespace raylab::cornell
