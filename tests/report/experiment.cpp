#include "raylab/report/experiment.h"

#include "catch.h"
#include "raylab/report/chart/pareto.h"
#include "raylab/report/stability.h"
#include "raylab/report/table.h"

#include <nlohmann/json.hpp>

#include <limits>

using namespace raylab;

TEST_CASE("the Pareto front holds what nothing beats, by rising error") {
    const std::vector<Tradeoff> points = {{10, 1}, {5, 2}, {5, 3}, {1, 9}, {2, 9}, {0, 20}, {20, 1}};
    CHECK(pareto_front(points) == std::vector<std::size_t>{5, 3, 1, 0});
}

TEST_CASE("equals are both on the front, and what is no number is not") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(pareto_front(std::vector<Tradeoff>{{1, 1}, {1, 1}}) == std::vector<std::size_t>{0, 1});
    CHECK(pareto_front(std::vector<Tradeoff>{{nan, 0}, {0, nan}, {1, 1}}) == std::vector<std::size_t>{2});
    CHECK(pareto_front({}).empty());
}

namespace {

Measurement row(const std::string& method, const std::string& workload, double error, double time) {
    return {.method = method,
            .number = "float",
            .workload = workload,
            .error = error,
            .error_bound = 30,
            .nanoseconds = {time, time, time},
            .queries = 100'000};
}

}  // namespace

TEST_CASE("each workload has a front of its own") {
    const Experiment experiment{
        "q",
        "Q?",
        "wrong [ppm]",
        {row("a", "w1", 0, 5), row("b", "w1", 9, 6), row("a", "w2", 9, 5), row("b", "w2", 0, 6)}};
    CHECK(workloads_of(experiment) == std::vector<std::string>{"w1", "w2"});
    CHECK(methods_of(experiment) == std::vector<std::string>{"a", "b"});
    CHECK(front_of(experiment, "w1") == std::vector<std::size_t>{0});
    CHECK(front_of(experiment, "w2") == std::vector<std::size_t>{3, 2});
}

TEST_CASE("no error seen is said with its bound") {
    CHECK(error_text(row("a", "w", 0, 1)) == "0 (< 30)");
    CHECK(error_text(row("a", "w", 12.34, 1)) == "12.3");
    auto unbounded = row("a", "w", 0, 1);
    unbounded.error_bound = 0;
    CHECK(error_text(unbounded) == "0");
}

TEST_CASE("CSV quotes commas, quotes and line breaks, and nothing else") {
    CHECK(csv_record({"a", "b,c", "d\"e", "f\ng", ""}) == "a,\"b,c\",\"d\"\"e\",\"f\ng\",\r\n");
}

TEST_CASE("an experiment's CSV has one record a row, with every count that any row has") {
    Experiment experiment{"q", "Q?", "wrong, in ppm", {row("a", "w", 1, 2), row("b", "w", 0, 3)}};
    experiment.rows[1].counts["miss ppm"] = 7;
    const auto csv = to_csv(experiment);
    CHECK(csv.find("\"wrong, in ppm\"") != std::string::npos);
    CHECK(csv.find(",miss ppm\r\n") != std::string::npos);
    CHECK(csv.find("a,float,,w,1,30,2,2,2,0,100000,yes,\r\n") != std::string::npos);
    CHECK(csv.find("b,float,,w,0,30,3,3,3,0,100000,yes,7\r\n") != std::string::npos);
}

TEST_CASE("an experiment's JSON holds its numbers exactly") {
    const Experiment experiment{"q", "Q?", "wrong", {row("a\"b", "w", 0.1, 1.0 / 3)}};
    const auto json = nlohmann::json::parse(to_json(experiment).dump());
    CHECK(json["rows"][0]["method"] == "a\"b");
    CHECK(json["rows"][0]["error"].get<double>() == 0.1);
    CHECK(json["rows"][0]["nanoseconds"]["median"].get<double>() == 1.0 / 3);
    CHECK(json["rows"][0]["on_front"] == true);
}

TEST_CASE("a case is as expected if every row is, and there is one") {
    const CaseRow good{"m", "fails", "failed", true};
    const CaseRow bad{"m", "fails", "held", false};
    CHECK(CaseOutcome{"C", "", {good, good}}.as_expected());
    CHECK(!CaseOutcome{"C", "", {good, bad}}.as_expected());
    CHECK(!CaseOutcome{"C", "", {}}.as_expected());
}

TEST_CASE("outcomes are told in words and as JSON") {
    const std::vector<CaseOutcome> outcomes = {{"EDGE", "a \"hard\" one", {{"m", "leaks > 1 %", "0 %", false}}}};
    const auto text = to_text(outcomes);
    CHECK(text.find("✗ not as expected") != std::string::npos);
    CHECK(text.find("0 of 1 cases as expected") != std::string::npos);
    const auto json = nlohmann::json::parse(to_json(outcomes));
    CHECK(json[0]["about"] == "a \"hard\" one");
    CHECK(json[0]["as_expected"] == false);
    CHECK(json[0]["rows"][0]["observed"] == "0 %");
}

TEST_CASE("broken UTF-8 in a name does not break the JSON") {
    const std::vector<CaseOutcome> outcomes = {{"\xff", "", {}}};
    CHECK_NOTHROW(nlohmann::json::parse(to_json(outcomes)));
}

TEST_CASE("columns line up whatever the alphabet") {
    CHECK(length_shown("Möller ✓") == 8);
    CHECK(text_table({"a", "b"}, {{"ö", "1"}, {"long", "2"}}) == "  a     b\n  ----  -\n  ö     1\n  long  2\n");
}

TEST_CASE("numbers for people have three digits and a unit that fits") {
    CHECK(number_text(0) == "0");
    CHECK(number_text(12.345) == "12.3");
    CHECK(number_text(999.6) == "1 000");
    CHECK(number_text(123456.7) == "123 457");
    CHECK(number_text(1.5e7) == "1.50e+07");
    CHECK(number_text(1e-5) == "1.00e-05");
    CHECK(duration_text(12.34) == "12.3 ns");
    CHECK(duration_text(2.5e9) == "2.5 s");
    CHECK(duration_text(0.5) == "0.5 ns");
}
