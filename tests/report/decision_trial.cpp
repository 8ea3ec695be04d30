#include "raylab/report/decision_trial.h"

#include "catch.h"
#include "raylab/report/case_drawings.h"

using namespace raylab;

namespace {

using Side = Method<int, int, std::optional<double>>;

Side saying(const std::string& name, const std::vector<std::optional<double>>& answers) {
    return {name, "float", "", {}, [answers](const auto&, auto, auto queries, auto out) {
                for (std::size_t i = 0; i < queries.size(); ++i) out[i] = answers[i];
            }};
}

}  // namespace

TEST_CASE("a row shows the first query that its method decides wrongly, with the truth") {
    // A ray in the triangle's plane, of which neither answer is wrong, one that hits, and one that misses.
    const TriangleOf<double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const Truth truth{oracle::intersect(RayOf<double>{{-1, 1, 0}, {1, 0, 0}, {0, 2}}, triangle),
                      oracle::intersect(RayOf<double>{{1, 1, 1}, {0, 0, -1}, {0, 2}}, triangle),
                      oracle::intersect(RayOf<double>{{9, 9, 1}, {0, 0, -1}, {0, 2}}, triangle)};
    DecisionTrial<int, int, std::optional<double>> trial(
        {"three", "", {}, {10, 11, 12}}, {saying("right", {{}, 1, {}}), saying("hits all", {1, 1, 1})}, truth);
    CHECK_FALSE(trial.more_wrong_than(0.4, "hits all, float").example);
    trial.show_wrong_ones([](const auto&, int query, TrueAnswer answer) {
        return CaseExample{std::to_string(query) + (answer == TrueAnswer::hit ? " hits" : " misses"), {}};
    });
    CHECK_FALSE(trial.never_wrong("right, float").example);
    CHECK(trial.more_wrong_than(0.4, "hits all, float").example.value().words == "12 misses");
}

TEST_CASE("an example's words hold its numbers, and its drawing the truth") {
    const auto ball = example_of(Ray{{0.1f, 2, 0}, {0, -1, 0}}, Sphere{{0, 0, 0}, 1}, TrueAnswer::hit);
    CHECK(ball.words == "ray from [0.1, 2, 0] along [0, -1, 0], sphere about [0, 0, 0] of radius 1");
    const auto svg = to_svg(ball.drawing);
    CHECK(svg.find("It passes the centre at 0.1 radii.") != std::string::npos);
    CHECK(svg.find("In truth it hits.") != std::string::npos);
    const auto triangle =
        example_of(Ray{{0, 0, 1}, {0, 0, -1}}, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, TrueAnswer::miss);
    CHECK(triangle.words == "ray from [0, 0, 1] along [0, 0, -1], triangle [0, 0, 0], [1, 0, 0], [0, 1, 0]");
    CHECK(to_svg(triangle.drawing).find("In truth it misses.") != std::string::npos);
}
