#include "form_factor_question.h"

#include "squares.h"

#include "raylab/radiosity/form_factor/form_factor_methods.h"

#include <algorithm>
#include <cmath>

namespace raylab::cornell {

namespace {

struct NamedPair {
    std::string name;
    KnownPair pair;
};

std::vector<NamedPair> subjects() {
    return {{"squares 5 apart", facing_5_apart()},
            {"squares 0.5 apart", facing_half_apart()},
            {"squares that share an edge", sharing_an_edge()}};
}

constexpr double digits_of_truth = 1e-15;  // a smaller error is none that could be seen

// Which method gets within a thousandth soonest, for each pair. Closed forms know rectangles only.
std::string soonest(const Experiment& experiment) {
    std::string text = "Within a thousandth, for any polygon, soonest: ";
    for (const NamedPair& subject : subjects()) {
        const Measurement* best = nullptr;
        for (const Measurement& row : experiment.rows)
            if (row.workload == subject.name && row.error <= 1e-3 && row.method != "closed" &&
                (!best || row.nanoseconds.median < best->nanoseconds.median))
                best = &row;
        if (text.back() == ')') text += "; ";
        text += (best ? best->method + (best->knob.empty() ? "" : " by " + best->knob) : "none") + " (" + subject.name +
                ")";
    }
    return text;
}

// The most time that one answer may take on a chart that is made while one waits.
constexpr int most_effort_in_quick_run = 64;

}  // namespace

Experiment measure_form_factors(const ChapterRun& run) {
    Experiment experiment{.question = "form_factors",
                          .title = "How much of a square's light arrives at another?",
                          .error_axis = "relative error",
                          .rows = {},
                          .answer = soonest};
    for (const auto& [name, pair] : subjects())
        for (const FormFactorMethod& method : form_factor_methods())
            for (const int effort : method.efforts) {
                if (run.effort == ChapterRun::Effort::quick && effort > most_effort_in_quick_run) continue;
                const auto answer = [&] { return method.answer(pair.from, pair.to, effort); };
                const auto value = answer();
                if (!value) continue;
                experiment.rows.push_back(
                    {.method = method.name,
                     .number = "double",
                     .workload = name,
                     .knob = method.effort_text(effort),
                     .source = method.source,
                     .error = std::max(std::abs(value->value / pair.form_factor - 1), digits_of_truth),
                     .nanoseconds = time_per_query(
                         1, [&] { answer(); }, run.timing()),
                     .queries = 1});
            }
    return experiment;
}

}  // namespace raylab::cornell
