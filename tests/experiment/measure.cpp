#include "raylab/experiment/measure/measure.h"

#include "catch.h"

#include <chrono>
#include <thread>

using namespace raylab;

TEST_CASE("a spread is the median and the quartiles, interpolated between neighbours") {
    const auto odd = spread_of({5, 1, 4, 2, 3});
    CHECK(odd.median == 3);
    CHECK(odd.low == 2);
    CHECK(odd.high == 4);
    const auto even = spread_of({4, 1, 3, 2});
    CHECK(even.median == 2.5);
    CHECK(even.low == 1.75);
    CHECK(even.high == 3.25);
    CHECK(spread_of({7}).high == 7);
}

TEST_CASE("a median is not moved by one slow repeat") { CHECK(spread_of({1, 1, 1, 1, 1, 1, 1000}).median == 1); }

TEST_CASE("time per query is the time of a pass over its queries") {
    const auto sleep = [] { std::this_thread::sleep_for(std::chrono::milliseconds(2)); };
    const auto spread = time_per_query(1000, sleep, {.repeats = 3, .shortest = 0.001});
    CHECK(spread.median >= 2000);  // 2 ms over 1000 queries, in nanoseconds
    CHECK(spread.median < 20000);  // a busy machine sleeps longer, but not ten times
    CHECK(spread.low <= spread.median);
    CHECK(spread.median <= spread.high);
}

TEST_CASE("by the thread's own clock, who waits takes no time") {
    const auto sleep = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
    const auto spread = time_per_query(1, sleep, {.repeats = 1, .shortest = 0, .clock = MeasureOptions::Clock::thread});
    CHECK(spread.median > 0);
    CHECK(spread.median < 5e6);
}

TEST_CASE("a short pass is repeated until the batch lasts") {
    std::size_t passes = 0;
    time_per_query(1, [&] { ++passes; }, {.repeats = 1, .shortest = 0.001});
    CHECK(passes > 1000);
}

TEST_CASE("no queries take no time") {
    CHECK(time_per_query(0, [] {}).median == 0);
}

TEST_CASE("measuring runs a method with its preparation and lets the judge see its answers") {
    const Method<int, int, int> method{
        .name = "sum",
        .number = "exact",
        .source = "",
        .prepare = [](std::span<const int> data) { return std::any(data[0] + data[1]); },
        .answer =
            [](const std::any& state, std::span<const int>, std::span<const int> queries, std::span<int> results) {
                for (std::size_t i = 0; i < queries.size(); ++i) results[i] = std::any_cast<int>(state) + queries[i];
            }};
    const Workload<int, int> workload{"small", "", {1, 2}, {10, 20}};
    std::vector<int> seen;
    const auto judge = [&](std::span<const int> answers) {
        seen.assign(answers.begin(), answers.end());
        return Judgement{.error = 0.5, .error_bound = 1.5, .counts = {{"misses", 1}}};
    };
    const auto row = measure<int, int, int>(method, workload, judge, {.repeats = 3, .shortest = 1e-5});
    CHECK(seen == std::vector<int>{13, 23});
    CHECK(row.method == "sum");
    CHECK(row.workload == "small");
    CHECK(row.queries == 2);
    CHECK(row.error == 0.5);
    CHECK(row.error_bound == 1.5);
    CHECK(row.counts.at("misses") == 1);
    CHECK(row.nanoseconds.median > 0);
    CHECK(row.prepare_nanoseconds.median > 0);
}

TEST_CASE("a method's answers take processor time, whatever else the machine does, and its preparation elapsed time") {
    const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
    const Method<int, int, int> method{
        .name = "waits",
        .number = "exact",
        .source = "",
        .prepare =
            [=](std::span<const int>) {
                wait();
                return std::any();
            },
        .answer = [=](const std::any&, std::span<const int>, std::span<const int>, std::span<int>) { wait(); }};
    const auto judge = [](std::span<const int>) { return Judgement{}; };
    const auto row = measure<int, int, int>(method, {"one", "", {}, {1}}, judge, {.repeats = 1, .shortest = 0});
    CHECK(row.nanoseconds.median < 5e6);
    CHECK(row.prepare_nanoseconds.median >= 20e6);
}
