#include "error_chart.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace raylab::bench {

namespace {

constexpr const char* aimed = "aimed";
constexpr double million = 1e6;

struct Totals {
    double log_nanoseconds = 0, log_slowest = 0, log_fastest = 0;
    int timed = 0;
    std::size_t leaks = 0, aimed_rays = 0;

    void add(const Row& row) {
        if (row.rays == aimed) {
            leaks += row.wrong;
            aimed_rays += row.ray_count;
            return;
        }
        log_nanoseconds += std::log(1e9 / row.rays_per_second);
        log_slowest += std::log(1e9 / row.slowest);
        log_fastest += std::log(1e9 / row.fastest);
        ++timed;
    }
    Spread nanoseconds() const {
        return {std::exp(log_nanoseconds / timed), std::exp(log_fastest / timed), std::exp(log_slowest / timed)};
    }
};

std::string source_of(const std::string& peer) {
    if (peer.starts_with("embree")) return "Embree 3";
    return peer == "cgal" ? "CGAL's AABB_tree" : "raylab";
}

}  // namespace

Experiment error_against_speed(const std::vector<Row>& rows) {
    std::vector<std::string> peers;
    std::map<std::string, Totals> totals;
    for (const Row& row : rows) {
        if (row.threads != rows.front().threads) continue;
        if (!totals.contains(row.peer)) peers.push_back(row.peer);
        totals[row.peer].add(row);
    }
    Experiment experiment{.question = "bench",
                          .title = "What does exact visibility cost? Wrong on rays aimed at vertices and edges, "
                                   "timed on all others.",
                          .error_axis = "wrong decisions [ppm]"};
    for (const std::string& peer : peers) {
        const Totals& of = totals[peer];
        if (of.aimed_rays == 0 || of.timed == 0) continue;
        const auto rays = static_cast<double>(of.aimed_rays);
        experiment.rows.push_back({.method = peer,
                                   .number = "",
                                   .workload = "all meshes and rays",
                                   .source = source_of(peer),
                                   .error = million * static_cast<double>(of.leaks) / rays,
                                   .error_bound = 3 * million / rays,  // rule of three
                                   .nanoseconds = of.nanoseconds(),
                                   .queries = of.aimed_rays});
    }
    return experiment;
}

}  // namespace raylab::bench
