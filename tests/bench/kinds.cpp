#include "kinds.h"
#include "catch.h"
#include "error_chart.h"
#include "mean_ratio.h"
#include "meshes.h"

#include "raylab/report/finding.h"

#include <cmath>
#include <set>

// Tables and charts of rows that were not raced but made up.

using namespace raylab;
using namespace raylab::bench;

namespace {

Row made_up(const std::string& mesh, const std::string& rays, const std::string& peer, double rays_per_second) {
    return {.mesh = mesh,
            .rays = rays,
            .peer = peer,
            .question = rays == "shadow" ? RayQuestion::any : RayQuestion::nearest,
            .triangles = 100,
            .ray_count = 1000,
            .rays_per_second = rays_per_second,
            .slowest = rays_per_second,
            .fastest = rays_per_second,
            .build_seconds = 1 / rays_per_second,
            .bytes = 1000};
}

// On scans ours is as fast, in the two halls half and an eighth as fast.
std::vector<Row> three_meshes() {
    std::vector<Row> rows;
    for (const auto& [mesh, speed] : {std::pair{"bunny", 8.0}, {"hall_3", 4.0}, {"hall_4", 1.0}})
        for (const char* rays : {"primary", "shadow", "aimed"}) {
            rows.push_back(made_up(mesh, rays, "embree_high", 8));
            rows.push_back(made_up(mesh, rays, "bvh8", speed));
            if (rays == std::string("aimed")) rows[rows.size() - 2].wrong = 20;
        }
    return rows;
}

}  // namespace

TEST_CASE("every mesh is of one kind, and those that usually race are of three") {
    std::set<std::string> kinds;
    for (const std::string& mesh : usual_meshes()) kinds.insert(kind_of_mesh(mesh));
    kinds.insert("scans");  // they may not have been fetched
    CHECK(kinds == std::set<std::string>{"scans", "architecture", "generated"});
    CHECK(kind_of_mesh("bunny") == "scans");
    CHECK(kind_of_mesh("city_2") == "architecture");
    CHECK(kind_of_mesh("bumpy_3") == "generated");
    CHECK(kind_of_mesh("some/where.off") == "files");
}

TEST_CASE("the mean of ratios is geometric, over what both peers have") {
    const auto rows = three_meshes();
    const auto ratio = mean_ratio(rows, {"bvh8"}, {"embree_high"}, speed_of, is_closest);
    REQUIRE(ratio);
    CHECK_THAT(*ratio, WithinRel(std::cbrt(1.0 / 16), 1e-12));
    CHECK_FALSE(mean_ratio(rows, {"bvh8"}, {"cgal"}, speed_of, is_closest));
    CHECK_FALSE(mean_ratio(rows, {"bvh8", 2}, {"embree_high"}, speed_of, is_closest));
}

TEST_CASE("kinds weigh alike in a goal, however many meshes they have, and aimed rays are not raced") {
    const std::string goals = goals_table(three_meshes());
    INFO(goals);
    // A quarter in the halls, and one on scans.
    CHECK_THAT(goals, Catch::Contains("mean over kinds  0.50  at least 1.00  missed"));
    CHECK_THAT(goals, Catch::Contains("where it is least            0.25  at least 0.95  missed"));
    CHECK_THAT(goals, Catch::Contains("wrong hit decisions"));
    const std::string kinds = kinds_table(three_meshes());
    INFO(kinds);
    CHECK_THAT(kinds, Catch::Contains("architecture  bvh8         0.25     0.25"));
}

TEST_CASE("without Embree's build of high quality there are no goals") {
    auto rows = three_meshes();
    std::erase_if(rows, [](const Row& row) { return row.peer == "embree_high"; });
    CHECK(goals_table(rows).empty());
    CHECK_THAT(kinds_table(rows), Catch::Contains("bvh8 = 1"));
}

TEST_CASE("a peer's error is that of aimed rays alone, and its time that of all others") {
    const Experiment chart = error_against_speed(three_meshes());
    REQUIRE(chart.rows.size() == 2);
    CHECK(chart.rows[0].method == "embree_high");
    CHECK_THAT(chart.rows[0].error, WithinRel(20'000, 1e-12));
    CHECK_THAT(chart.rows[0].nanoseconds.median, WithinRel(1e9 / 8, 1e-12));
    CHECK(chart.rows[1].error == 0);
    CHECK_THAT(chart.rows[1].error_bound, WithinRel(1000, 1e-12));
    CHECK_THAT(answer_of(chart), Catch::Contains("bvh8: no wrong decisions in "));
    CHECK(error_against_speed({three_meshes().front()}).rows.empty());
}
