#pragma once

#include "meshes.h"
#include "peer.h"
#include "rays.h"

#include <cstddef>
#include <string>
#include <vector>

namespace raylab::bench {

/// Which seconds are measured: elapsed time, or the processor time of this program.
enum class Seconds { wall, processor };

/// What is measured, and how often.
struct RaceOptions {
    std::vector<std::string> meshes, rays, peers;
    std::vector<int> threads = {1};
    int repetitions = 5;   // the median is taken
    int size = 1024;       // size * size rays of each kind
    double longest = 0.5;  // seconds for each repetition: a slow peer gets only a part of the rays
    Seconds clock = Seconds::wall;
};

/// The work per ray, averaged over some of the rays; 0 where the peer does not count.
struct Work {
    double steps = 0, box_tests = 0, primitive_tests = 0, exact_decisions = 0;
};

/// One peer on one mesh and one kind of rays.
struct Row {
    std::string mesh, rays, peer;
    RayQuestion question = RayQuestion::nearest;
    int threads = 1;
    std::size_t triangles = 0;
    std::size_t ray_count = 0;  // traced by this peer
    std::size_t hits = 0;       // by exact arithmetic
    double rays_per_second = 0, slowest = 0, fastest = 0;
    double build_seconds = 0;
    std::size_t bytes = 0;
    std::size_t wrong = 0;  // a hit where there is none, or none where there is one
    std::size_t other = 0;  // closest hit: another triangle than the exact nearest one (ties: the lowest number)
    Work work = {};
};

/// Runs every peer over every kind of rays on one mesh. In each repetition all peers take a turn, so that all are
/// subject to the same disturbances.
std::vector<Row> race(const std::string& mesh, const RaceOptions& options);

}  // namespace raylab::bench
