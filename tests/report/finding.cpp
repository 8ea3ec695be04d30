#include "raylab/report/finding.h"

#include "catch.h"
#include "raylab/report/experiment_text.h"
#include "raylab/report/method_rows.h"
#include "raylab/report/table.h"

#include <sstream>

using namespace raylab;

namespace {

Measurement found(const std::string& method, const std::string& workload, double error, double time) {
    return {.method = method,
            .number = "float",
            .workload = workload,
            .error = error,
            .error_bound = 30,
            .nanoseconds = {time, 0.98 * time, 1.02 * time},
            .queries = 100'000};
}

Experiment decisions(const std::vector<Measurement>& rows) { return {"q", "Q?", "wrong decisions [ppm]", rows}; }

}  // namespace

TEST_CASE("the answer is the fastest method that is never wrong, beside the fastest of all on each workload") {
    CHECK(
        answer_of(decisions({found("plain", "easy", 12, 10), found("plain", "hard", 380'000, 10),
                             found("exact", "easy", 0, 11), found("exact", "hard", 0, 61), found("slow", "easy", 0, 90),
                             found("slow", "hard", 0, 90)})) ==
        "exact: no wrong decisions in 200 000 queries, 1.10 × the fastest's time on easy, 6.1 × on hard (the fastest: "
        "38 % wrong)");
}

TEST_CASE("a tie is as fast as any") {
    const auto plain = found("plain", "easy", 12, 10), tie = found("exact", "easy", 0, 10.3);
    CHECK(answer_of(decisions({plain, tie})) == "exact: no wrong decisions in 100 000 queries, as fast as any");
    CHECK(answer_of(decisions({plain, tie, found("plain", "hard", 0, 10), found("plain", "odd", 0, 10),
                               found("exact", "hard", 0, 20), found("exact", "odd", 0, 10)})) ==
          "exact: no wrong decisions in 300 000 queries, as fast as any on easy and odd, 2.0 × the fastest's time on "
          "hard");
}

TEST_CASE("a method that was not measured everywhere is no answer, but it may be the fastest somewhere") {
    CHECK(answer_of(decisions(
              {found("special", "easy", 0, 5), found("general", "easy", 0, 10), found("general", "hard", 0, 10)})) ==
          "general: no wrong decisions in 200 000 queries, as fast as any on hard, 2.0 × the fastest's time on easy");
    CHECK(answer_of(decisions({found("a", "easy", 0, 5), found("b", "hard", 0, 5)})) ==
          "2 methods, none of them measured everywhere");
}

TEST_CASE("where every method is wrong somewhere, the answer is the one that is so least") {
    CHECK(answer_of(decisions({found("a", "w", 500, 10), found("b", "w", 12, 20)})) ==
          "b: fewest wrong decisions, at most 12 ppm, 2.0 × the fastest's time (the fastest: 0.05 % wrong)");
}

TEST_CASE("of errors with a unit, the answer is the least, and of nearly the same the fastest") {
    Experiment experiment{
        "q", "Q?", "error of t [ulp]", {found("a", "w", 900, 5), found("b", "w", 1.05, 20), found("c", "w", 1, 30)}};
    CHECK(answer_of(experiment) == "b errs least, at most 1.05 ulp: 4.0 × the fastest's time");
}

TEST_CASE("a chart may have words of its own") {
    auto experiment = decisions({found("a", "w", 0, 1)});
    experiment.answer = [](const Experiment& own) { return own.question + " has an answer"; };
    CHECK(answer_of(experiment) == "q has an answer");
}

TEST_CASE("of a method with settings the answer is the cheapest that is good enough on every workload") {
    const auto set = [](const std::string& method, const std::string& workload, int rays, double error) {
        auto row = found(method, workload, error, 10 * rays);
        row.knob = std::to_string(rays) + " rays";
        return row;
    };
    Experiment experiment{"q", "Q?", "RMS error", {}, answer_within(0.05)};
    for (const int rays : {4, 16, 64}) {
        experiment.rows.push_back(set("jittered", "edges", rays, 0.4 / rays));
        experiment.rows.push_back(set("jittered", "slivers", rays, 0.2 / rays));
        experiment.rows.push_back(set("random", "edges", rays, 2.0 / rays));
        experiment.rows.push_back(set("random", "slivers", rays, 2.0 / rays));
        experiment.rows.push_back(set("regular", "edges", rays, 0.5 / rays));
        experiment.rows.push_back(set("regular", "slivers", rays, 2.0 / rays));
        experiment.rows.push_back(set("centre", "edges", rays, 0.01));
        experiment.rows.push_back(set("centre", "slivers", rays, 0.3));
    }
    CHECK(answer_of(experiment) ==
          "An error below 0.05 takes 16 rays by jittered, 16 to 64 rays by regular (2.0 × the time), 64 rays by random "
          "(4.0 × the time); centre does not reach it everywhere");
}

TEST_CASE("methods are in order of their worst error, then of their time relative to the fastest") {
    std::vector<std::string> names;
    for (const auto& method :
         methods_in_order(decisions({found("wrong", "a", 0, 1), found("wrong", "b", 9, 1), found("slow", "a", 0, 4),
                                     found("slow", "b", 0, 4), found("fast", "b", 0, 3), found("worse", "b", 10, 1)})))
        names.push_back(method.name);
    CHECK(names == std::vector<std::string>{"fast", "slow", "wrong", "worse"});
}

TEST_CASE("a summary has a line for each method and at most 25, and all rows are there on request") {
    std::vector<Measurement> rows;
    for (int m = 0; m < 30; ++m)
        for (const std::string workload : {"easy", "hard"})
            rows.push_back(found("method " + std::to_string(m), workload, m, 10 + m));
    const auto lines_of = [](const std::string& text) {
        std::size_t count = 0;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line); ++count) CHECK(length_shown(line) <= terminal_width);
        return count;
    };
    const auto summary = summary_text(decisions(rows));
    CHECK(lines_of(summary) <= 25);
    CHECK(summary.starts_with("method 0: no wrong decisions in 200 000 queries, as fast as any\nQ?\n"));
    CHECK(summary.find("and 13 more") != std::string::npos);
    CHECK(lines_of(rows_text(decisions(rows))) > 60);
}
