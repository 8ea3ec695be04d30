#include "ask_quiz.h"

#include "quiz.h"

#include "raylab/base/error.h"
#include "raylab/base/print.h"
#include "raylab/base/process.h"
#include "raylab/base/read_json.h"
#include "raylab/base/temporary.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

namespace {

using namespace grading;

constexpr double patience = 120;  // seconds for a stability case, or a chart, in its quick form

std::optional<std::string> typed_line() {
    print_text("> ");
    flush_standard_output();
    std::string line;
    if (!std::getline(std::cin, line)) return std::nullopt;
    const auto begin = line.find_first_not_of(" \t\r");
    return begin == std::string::npos ? "" : line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
}

struct QuizScore {
    std::size_t right = 0, judged = 0;
    bool ended = false;

    void count(bool is_right) {
        ++judged;
        right += is_right;
    }
};

void ask_question(const QuizQuestion& question, QuizScore& score) {
    print_text("\n" + question.asks + "\n");
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        print_text(fmt::format("  {}  {}\n", i + 1, question.choices[i]));
    if (!question.is_judged()) print_text("(Think, then press Enter.)\n");
    const auto answer = typed_line();
    score.ended = !answer;
    if (!answer) return;
    if (!question.is_judged()) {
        print_text(question.answer + "\n");
        return;
    }
    const bool is_right = is_answer(question, *answer);
    score.count(is_right);
    print_text((is_right ? "Right. " : "No. ") + (question.seal ? "" : question.answer) + "\n");
}

// What `raylab stability NAME` or `raylab chart NAME` finds just now.
nlohmann::ordered_json found_by(const std::string& command, const std::string& name) {
    const ScratchFolder scratch;
    const auto data = scratch.path() / "found.json";
    const auto run =
        run_process("/proc/self/exe", {command, name, "--quick", "--json", data.string()}, {.timeout = patience});
    if (!std::filesystem::exists(data)) throw Error(name + ", " + failure_of("raylab " + command, run));
    return read_json(data);
}

void ask_prediction(const Prediction& prediction, QuizScore& score) {
    print_text(
        fmt::format("\nPredict, before it runs: stability case {}, by {}. Does it hold, or does it fail? (h or f)\n",
                    prediction.stability_case, prediction.method));
    const auto guess = typed_line();
    score.ended = !guess;
    if (!guess) return;
    const auto outcome = found_by("stability", prediction.stability_case).at(0);
    for (const auto& row : outcome.at("rows")) {
        if (row.at("method") != prediction.method) continue;
        const auto expected = row.at("expected").get<std::string>();
        const bool is_right = !guess->empty() && !expected.empty() && (*guess)[0] == expected[0];
        score.count(is_right);
        print_text(fmt::format("{} {}\nObserved just now: {} (expected: {}).\n", is_right ? "Right." : "No.",
                               outcome.at("about").get<std::string>(), row.at("observed").get<std::string>(),
                               expected));
        return;
    }
    throw Error("the stability case " + prediction.stability_case + ": expected a method " + prediction.method +
                ", found none");
}

// The errors of the methods that are asked for, in their order.
std::vector<double> measured_errors(const OrderToPredict& order) {
    const auto chart = found_by("chart", order.chart);
    std::vector<double> errors;
    for (const auto& method : order.methods) {
        const auto& rows = chart.at("rows");
        const auto row = std::ranges::find_if(rows, [&](const auto& each) {
            return each.at("method").template get<std::string>() + ", " +
                           each.at("number").template get<std::string>() ==
                       method &&
                   each.at("workload") == order.workload && each.at("knob") == order.knob;
        });
        if (row == rows.end())
            throw Error(fmt::format("the chart {}: expected {} on {} {}, found none", order.chart, method,
                                    order.workload, order.knob));
        errors.push_back(row->at("error").get<double>());
    }
    return errors;
}

void ask_order(const OrderToPredict& order, QuizScore& score) {
    print_text(fmt::format("\nPredict, before it is measured: the chart {}, {}{}. Put these in order, the most exact "
                           "first (such as 2 1 3):\n",
                           order.chart, order.workload, order.knob.empty() ? "" : ", " + order.knob));
    for (std::size_t i = 0; i < order.methods.size(); ++i)
        print_text(fmt::format("  {}  {}\n", i + 1, order.methods[i]));
    const auto guess = typed_line();
    score.ended = !guess;
    if (!guess) return;
    const auto errors = measured_errors(order);
    const bool is_right = is_order(errors, *guess);
    score.count(is_right);
    print_text(is_right ? "Right. Their errors just now:\n" : "No. Their errors just now:\n");
    for (std::size_t i = 0; i < errors.size(); ++i)
        print_text(fmt::format("  {:<9.3g}  {}\n", errors[i], order.methods[i]));
}

}  // namespace

ExitCode ask_quiz(const Exercise& exercise) {
    const auto quiz = read_quiz(exercise);
    print_text(fmt::format("Chapter {}: {} questions, {} to predict. A number, or the number of a choice.\n",
                           exercise.chapter.substr(0, 2), quiz.questions.size(),
                           quiz.predictions.size() + quiz.orders.size()));
    QuizScore score;
    for (const auto& question : quiz.questions)
        if (!score.ended) ask_question(question, score);
    for (const auto& prediction : quiz.predictions)
        if (!score.ended) ask_prediction(prediction, score);
    for (const auto& order : quiz.orders)
        if (!score.ended) ask_order(order, score);
    print_text(
        fmt::format("\n{} of {} right{}\n", score.right, score.judged, score.ended ? ", not all were answered" : ""));
    return !score.ended && score.right == score.judged ? ExitCode::as_it_should_be : ExitCode::negative;
}

}  // namespace raylab
