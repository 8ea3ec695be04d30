#include "catch.h"

#include "raylab/experiment/measure/wrong_decisions.h"
#include "raylab/report/decision_trial.h"

#include <array>
#include <optional>

using namespace raylab;
using oracle::HitKind;

namespace {

using Hits = std::vector<std::optional<double>>;
using Side = Method<int, int, std::optional<double>>;

// A triangle in the plane z = 0 with rays from above (hit), beside it (miss), from below its range (miss), in its plane
// (within).
Truth four_rays() {
    const TriangleOf<double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const std::array<RayOf<double>, 4> rays{{{{1, 1, 1}, {0, 0, -1}, {0, 2}},
                                             {{9, 9, 1}, {0, 0, -1}, {0, 2}},
                                             {{1, 1, 1}, {0, 0, -1}, {0, 0.5}},
                                             {{-1, 1, 0}, {1, 0, 0}, {0, 2}}}};
    return ask_oracle(rays.size(), 2, [&](std::size_t i) { return oracle::intersect(rays[i], triangle); });
}

Side answering(const std::string& name, const Hits& answers) {
    return {name, "float", "", {}, [answers](const auto&, auto, auto queries, auto out) {
                for (std::size_t i = 0; i < queries.size(); ++i) out[i] = answers[i];
            }};
}

}  // namespace

TEST_CASE("the oracle is asked about every query, and a meeting outside the range is a miss", "[threads]") {
    const Truth truth = four_rays();
    REQUIRE(truth.size() == 4);
    CHECK(truth[0].hit_kind == HitKind::interior);
    CHECK(truth[1].hit_kind == HitKind::miss);
    CHECK(truth[2].hit_kind == HitKind::miss);
    CHECK(truth[3].hit_kind == HitKind::within);
}

TEST_CASE("misses and false hits are counted apart, rays within the surface on their own") {
    const Truth truth = four_rays();
    const auto right = wrong_decisions(Hits{1, {}, {}, {}}, truth);
    CHECK(right.all() == 0);
    CHECK(right.within == 0);
    const auto wrong = wrong_decisions(Hits{{}, 1, 1, 1}, truth);
    CHECK_THAT(wrong.misses, WithinRel(1e6 / 3, 1e-12));
    CHECK(wrong.false_hits == Approx(2e6 / 3));
    CHECK_THAT(wrong.within, WithinRel(1e6 / 4, 1e-12));
}

TEST_CASE("a verdict bounds what was not seen, and names hits in the plane only where rays lie in it") {
    Truth truth = four_rays();
    const auto verdict = judge_decisions(Hits{{}, {}, {}, 1}, truth);
    CHECK_THAT(verdict.error, WithinRel(1e6 / 3, 1e-12));
    CHECK(verdict.error_bound == Approx(3e6 / 4));
    CHECK(verdict.counts.at("missed [ppm]") == verdict.error);
    CHECK_THAT(verdict.counts.at("hits in the plane [ppm]"), WithinRel(1e6 / 4, 1e-12));
    truth.pop_back();
    CHECK_FALSE(judge_decisions(Hits{1, {}, {}}, truth).counts.contains("hits in the plane [ppm]"));
}

TEST_CASE("each row of a trial holds only where its expectation does") {
    const std::vector methods{answering("right", {1, {}, {}, {}}), answering("misses", {{}, {}, {}, {}}),
                              answering("hits all", {1, 1, 1, 1})};
    const DecisionTrial<int, int, std::optional<double>> trial({"four", "", {}, {0, 1, 2, 3}}, methods, four_rays());
    CHECK(trial.never_wrong("right, float").as_expected);
    CHECK_FALSE(trial.never_wrong("misses, float").as_expected);
    CHECK(trial.more_wrong_than(0.6, "hits all, float").as_expected);
    CHECK_FALSE(trial.more_wrong_than(0.6, "misses, float").as_expected);
    CHECK(trial.less_wrong_than(0.6, "misses, float").as_expected);
    CHECK_FALSE(trial.less_wrong_than(0.6, "hits all, float").as_expected);
    CHECK(trial.more_missed_than(0.3, "misses, float").as_expected);
    CHECK_FALSE(trial.more_missed_than(0.3, "hits all, float").as_expected);
    CHECK(trial.shown(methods[2]).as_expected);
    const auto row = trial.less_wrong_than(0.003, "misses, float");
    CHECK(row.method == "misses, float: four");
    CHECK(row.expected == "holds: less than 0.3 % wrong");
    CHECK(row.observed == "33 % wrong (33 % missed, 0 false hits)");
}
