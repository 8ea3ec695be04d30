#pragma once

#include "meshes.h"
#include "peer.h"
#include "rays.h"

#include <cstddef>
#include <string>
#include <vector>

namespace raylab::bench {

/// Which seconds count: those that pass, or those the processor spends on this program.
enum class Seconds { wall, processor };

/// What is raced, and how often.
struct RaceOptions {
    std::vector<std::string> meshes, rays, peers;
    std::vector<int> threads = {1};
    int repetitions = 5;   // the median counts
    int size = 1024;       // size * size rays of each kind
    double longest = 0.5;  // seconds a repetition may take: a slow peer gets a part of the rays
    Seconds clock = Seconds::wall;
};

/// What a ray takes, in the mean over some of the rays; 0 where the peer does not count.
struct Work {
    double steps = 0, box_tests = 0, primitive_tests = 0, exact_decisions = 0;
};

/// One peer on one mesh and one kind of rays.
struct Row {
    std::string mesh, rays, peer;
    RayQuestion question = RayQuestion::nearest;
    int threads = 1;
    std::size_t triangles = 0;
    std::size_t ray_count = 0;  // that this peer was given
    std::size_t hits = 0;       // exact
    double rays_per_second = 0, slowest = 0, fastest = 0;
    double build_seconds = 0;
    std::size_t bytes = 0;
    std::size_t wrong = 0;  // a hit where there is none, or none where there is one
    std::size_t other = 0;  // closest hit: another triangle than the exact nearest one (ties: the lowest number)
    Work work = {};
};

/// Every peer over every kind of rays on one mesh: in each repetition all take a turn, so that all meet the same
/// disturbances.
std::vector<Row> race(const std::string& mesh, const RaceOptions& options);

}  // namespace raylab::bench
