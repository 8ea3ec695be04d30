#include "race.h"

#include "catch.h"
#include "processors.h"
#include "raylab/base/error.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

// Races with peers that are wrong, or slow, on purpose.

using namespace raylab;
using namespace raylab::bench;

namespace {

constexpr std::int32_t first = 0;

/// Gives every ray the same answer, slowly.
class AlwaysTheSame final : public Peer {
public:
    AlwaysTheSame(std::int32_t answer, std::chrono::microseconds pause) : answer_(answer), pause_(pause) {}
    void closest(std::span<const Ray>, std::span<std::int32_t> triangles) const override { fill(triangles); }
    void any(std::span<const Ray>, std::span<std::int32_t> triangles) const override { fill(triangles); }
    std::size_t bytes() const override { return 12; }

private:
    void fill(std::span<std::int32_t> triangles) const {
        std::this_thread::sleep_for(pause_ * triangles.size());
        std::ranges::fill(triangles, answer_);
    }
    std::int32_t answer_;
    std::chrono::microseconds pause_;
};

PeerKind always(const std::string& name, std::int32_t answer, std::chrono::microseconds pause = {}) {
    return {name,
            [=](int) -> Build { return [=](const Scene&) { return std::make_unique<AlwaysTheSame>(answer, pause); }; }};
}

/// For how many threads a peer was set up, and where it was built.
struct Stand {
    int threads;
    std::vector<int> processors;
};
std::vector<Stand> stands;

/// Notes where it is built.
PeerKind noting(const std::string& name, PeerKind::Threads whose) {
    const auto builder = [](int threads) -> Build {
        return [threads](const Scene&) {
            stands.push_back({threads, usable_processors()});
            return std::make_unique<AlwaysTheSame>(none, std::chrono::microseconds());
        };
    };
    return {name, builder, whose};
}

/// Where a peer is built twice for each number of threads, in order.
std::vector<Stand> stands_of(const std::string& peer, const std::vector<int>& threads) {
    stands.clear();
    race("bumpy_1", {.rays = {"segments"}, .peers = {peer}, .threads = threads, .repetitions = 2, .size = 8});
    return stands;
}

std::vector<int> threads_of(const std::vector<Stand>& those) {
    std::vector<int> threads;
    for (const Stand& one : those) threads.push_back(one.threads);
    return threads;
}

Row raced(const std::string& peer, const std::string& rays) {
    const auto rows = race("bumpy_2", {.meshes = {}, .rays = {rays}, .peers = {peer}, .repetitions = 1, .size = 32});
    REQUIRE(rows.size() == 1);
    return rows.front();
}

}  // namespace

// Replaces the function of peers.cpp.
PeerKind raylab::bench::peer_kind(const std::string& name) {
    if (name == "blind") return always(name, none);
    if (name == "sees triangle 0 everywhere") return always(name, first);
    if (name == "slow") return always(name, none, std::chrono::microseconds(200));
    if (name == "notes") return noting(name, PeerKind::Threads::of_its_own);
    if (name == "notes and shares") return noting(name, PeerKind::Threads::of_the_process);
    return raylab_peer(name);
}

TEST_CASE("a peer that sees nothing is wrong wherever there is a hit") {
    for (const std::string& rays : usual_rays()) {
        INFO(rays);
        const Row row = raced("blind", rays);
        CHECK(row.ray_count == 32 * 32);
        CHECK(row.hits > 15);
        CHECK(row.wrong == row.hits);
        CHECK(row.other == 0);
    }
}

TEST_CASE("a peer that sees something everywhere is wrong wherever there is nothing") {
    for (const std::string& rays : usual_rays()) {
        INFO(rays);
        const Row row = raced("sees triangle 0 everywhere", rays);
        CHECK(row.wrong == row.ray_count - row.hits);
        CHECK(row.wrong > 30);
    }
}

TEST_CASE("another triangle than the nearest is told apart from a wrong decision, where the nearest was asked for") {
    CHECK(raced("sees triangle 0 everywhere", "primary").other > 200);
    CHECK(raced("sees triangle 0 everywhere", "shadow").other == 0);
}

TEST_CASE("our structures answer as exact arithmetic does") {
    for (const std::string& rays : usual_rays()) {
        INFO(rays);
        const Row row = raced("bvh", rays);
        CHECK(row.wrong + row.other == 0);
        CHECK(row.bytes > 0);
        CHECK(row.rays_per_second > 0);
        CHECK(row.triangles == 320);
    }
}

TEST_CASE("rays aimed at vertices and edges are judged exactly, too") {
    const Row row = raced("list", "aimed");
    CHECK(row.hits > 900);  // of 1024, from inside
    CHECK(row.wrong + row.other == 0);
}

TEST_CASE("a slow peer is given whole blocks of some of the rays, and judged by these") {
    const auto rows =
        race("bumpy_2", {.rays = {"primary"}, .peers = {"slow", "bvh"}, .repetitions = 1, .size = 64, .longest = 0.2});
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].ray_count == 1024);  // the smallest number that is timed
    CHECK(rows[0].wrong == rows[0].hits);
    CHECK(rows[1].ray_count == 64 * 64);
}

TEST_CASE("the rays that a slow peer is given are of all parts of a picture") {
    const auto rows = race(
        "bumpy_2", {.rays = {"primary"}, .peers = {"slow", "bvh"}, .repetitions = 1, .size = 256, .longest = 0.01});
    REQUIRE(rows.size() == 2);
    REQUIRE(rows[0].ray_count == 1024);
    const auto share = [](const Row& row) {
        return static_cast<double>(row.hits) / static_cast<double>(row.ray_count);
    };
    CHECK(share(rows[1]) > 0.3);
    CHECK(std::abs(share(rows[0]) - share(rows[1])) < 0.1);
}

TEST_CASE("every peer races with every number of threads") {
    const auto rows = race(
        "bumpy_1", {.rays = {"segments"}, .peers = {"list", "blind"}, .threads = {1, 2}, .repetitions = 2, .size = 8});
    REQUIRE(rows.size() == 4);
    CHECK(std::ranges::count(rows, 2, &Row::threads) == 2);
    CHECK(std::ranges::count(rows, "list", &Row::peer) == 2);
}

TEST_CASE("builds with one thread and with two take turns, save where two threads for one peer are two for all") {
    CHECK(threads_of(stands_of("notes", {1, 2})) == std::vector{1, 2, 1, 2});
    CHECK(threads_of(stands_of("notes and shares", {1, 2})) == std::vector{1, 1, 2, 2});
}

TEST_CASE("where numbers of threads are compared, one thread takes the processors in turns") {
    const std::vector<int> all = usable_processors();
    REQUIRE(!all.empty());
    for (const Stand& one : stands_of("notes", {1})) CHECK(one.processors == all);
    const auto compared = stands_of("notes", {1, 2});
    CHECK(compared[0].processors == std::vector{all[0]});
    CHECK(compared[2].processors == std::vector{all[1 % all.size()]});
    CHECK(compared[1].processors == all);
    CHECK(usable_processors() == all);
}

TEST_CASE("a mesh or a kind of rays that nobody knows is refused") {
    CHECK_THROWS_AS(scene_of_mesh("teacup"), Error);
    CHECK_THROWS_AS(scene_of_mesh("knot_3"), Error);
    CHECK_THROWS_AS(ray_sets(scene_of_mesh("bumpy_1"), {"heat"}, 4), Error);
}
