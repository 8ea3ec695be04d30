#include "raylab/report/experiment.h"

#include "catch.h"
#include "raylab/report/chart/pareto.h"
#include "raylab/report/stability.h"
#include "raylab/report/table.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <sstream>

using namespace raylab;

namespace {

// Points of an error and a time without spread.
std::vector<Tradeoff> at(const std::vector<std::pair<double, double>>& points) {
    std::vector<Tradeoff> tradeoffs;
    for (const auto& [error, time] : points) tradeoffs.push_back({error, {time, time, time}});
    return tradeoffs;
}

}  // namespace

TEST_CASE("the Pareto front holds what nothing beats, by rising error") {
    const auto points = at({{10, 1}, {5, 2}, {5, 3}, {1, 9}, {2, 9}, {0, 20}, {20, 1}});
    CHECK(pareto_front(points) == std::vector<std::size_t>{5, 3, 1, 0});
}

TEST_CASE("equals are both on the front, and what is no number is not") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(pareto_front(at({{1, 1}, {1, 1}})) == std::vector<std::size_t>{0, 1});
    CHECK(pareto_front(at({{nan, 0}, {0, nan}, {1, 1}})) == std::vector<std::size_t>{2});
    CHECK(pareto_front({}).empty());
}

TEST_CASE("where quartiles overlap no time is less: equal errors are both on the front, a greater error is not") {
    const Spread five{5, 4.8, 5.3}, close{5.2, 5.1, 5.4}, six{6, 5.9, 6.2};
    CHECK(tied(five, close));
    CHECK_FALSE(tied(five, six));
    CHECK(pareto_front(std::vector<Tradeoff>{{0, five}, {0, close}}) == std::vector<std::size_t>{0, 1});
    CHECK(pareto_front(std::vector<Tradeoff>{{0, five}, {0, six}}) == std::vector<std::size_t>{0});
    CHECK(pareto_front(std::vector<Tradeoff>{{9, five}, {0, close}}) == std::vector<std::size_t>{1});
    CHECK(pareto_front(std::vector<Tradeoff>{{9, five}, {0, six}}) == std::vector<std::size_t>{1, 0});
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

TEST_CASE("what is wrong in more than one of a hundred is on no front, however fast; other errors have no such limit") {
    Experiment experiment{
        "q", "Q?", "wrong [ppm]", {row("a", "w", 10'001, 1), row("b", "w", 10'000, 2), row("c", "w", 0, 3)}};
    CHECK(front_of(experiment, "w") == std::vector<std::size_t>{2, 1});
    experiment.error_axis = "error [ulp]";
    CHECK(front_of(experiment, "w") == std::vector<std::size_t>{2, 1, 0});
}

TEST_CASE("the fastest of a front are all that tie with its fastest") {
    Experiment experiment{"q", "Q?", "wrong [ppm]", {row("a", "w", 0, 5), row("b", "w", 0, 5.5), row("c", "w", 0, 7)}};
    CHECK(fastest_of_front(experiment, "w") == std::vector<std::size_t>{0});
    experiment.rows[0].nanoseconds.high = 5.6;
    CHECK(fastest_of_front(experiment, "w") == std::vector<std::size_t>{0, 1});
}

TEST_CASE("errors are written as what they are: shares, or numbers with a unit") {
    const Experiment shares{"q", "Q?", "wrong decisions [ppm]", {}}, lengths{"q", "Q?", "error of t [ulp]", {}};
    CHECK(error_name(shares) == "wrong decisions");
    CHECK(error_unit(lengths) == "ulp");
    CHECK(error_unit({"q", "Q?", "RMS error", {}}).empty());
    CHECK(error_text(shares, 810'000) == "81 %");
    CHECK(error_text(lengths, 12.34) == "12.3");
}

TEST_CASE("no error seen is said with its bound") {
    const Experiment experiment{"q", "Q?", "wrong [ppm]", {}};
    CHECK(error_text(experiment, row("a", "w", 0, 1)) == "0 (< 30 ppm)");
    CHECK(error_text(experiment, row("a", "w", 12.34, 1)) == "12 ppm");
    auto unbounded = row("a", "w", 0, 1);
    unbounded.error_bound = 0;
    CHECK(error_text(experiment, unbounded) == "0");
}

TEST_CASE("a method's name has its number type where it was measured in several") {
    Experiment experiment{"q", "Q?", "wrong [ppm]", {row("a", "w", 0, 1), row("b", "w", 0, 1), row("a", "w", 0, 1)}};
    experiment.rows[2].number = "double";
    experiment.rows[1].knob = "4 rays";
    CHECK(name_of(experiment, experiment.rows[0]) == "a, float");
    CHECK(name_of(experiment, experiment.rows[1]) == "b, 4 rays");
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
    const CaseRow good{"m", "fails: wrong", "wrong", true};
    const CaseRow bad{"m", "fails: wrong", "right", false};
    CHECK(CaseOutcome{"C", "", {good, good}}.as_expected());
    CHECK(!CaseOutcome{"C", "", {good, bad}}.as_expected());
    CHECK(!CaseOutcome{"C", "", {}}.as_expected());
}

TEST_CASE("outcomes are told in words and as JSON") {
    const std::vector<CaseOutcome> outcomes = {
        {"EDGE", "a \"hard\" one", {{"m", "fails: more than 1 % leak", "0 %", false}}}};
    const auto text = to_text(outcomes);
    CHECK(text.find("‼ HOLDS, should fail  m") != std::string::npos);
    CHECK(text.find("0 of 1 cases as expected") != std::string::npos);
    const auto json = nlohmann::json::parse(to_json(outcomes));
    CHECK(json[0]["about"] == "a \"hard\" one");
    CHECK(json[0]["as_expected"] == false);
    CHECK(json[0]["rows"][0]["observed"] == "0 %");
}

TEST_CASE("a verdict says whether a failure was expected, and whether it came") {
    CHECK(verdict_text({"m", "fails: leaks", "leaks", true}) == "✗ fails, as expected");
    CHECK(verdict_text({"m", "fails: leaks", "none", false}) == "‼ HOLDS, should fail");
    CHECK(verdict_text({"m", "holds: none", "none", true}) == "✓ holds");
    CHECK(verdict_text({"m", "holds: none", "leaks", false}) == "‼ FAILS, should hold");
    CHECK(verdict_text({"m", "nothing: shown, not judged", "leaks", true}) == "not judged");
    CHECK(expected_words({"m", "holds: off by at most 1: or so", "", true}) == "off by at most 1: or so");
}

TEST_CASE("outcomes fit the terminal, however long their words are") {
    const std::string words =
        "many words that together are longer than any terminal is wide, and then some more of them";
    const auto text = to_text({{"CASE", words + " " + words, {{words, "holds: " + words, words, true}}}});
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) CHECK(length_shown(line) <= terminal_width);
}

TEST_CASE("broken UTF-8 in a name does not break the JSON") {
    const std::vector<CaseOutcome> outcomes = {{"\xff", "", {}}};
    CHECK_NOTHROW(nlohmann::json::parse(to_json(outcomes)));
}

TEST_CASE("columns line up whatever the alphabet") {
    CHECK(length_shown("Möller ✓") == 8);
    CHECK(text_table({"a", "b"}, {{"ö", "1"}, {"long", "2"}}) == "  a     b\n  ----  -\n  ö     1\n  long  2\n");
}
