#include "race.h"

#include "raylab/base/tiles.h"

#include <algorithm>
#include <chrono>

namespace raylab::bench {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// A peer that races with so many threads.
struct Entrant {
    std::string name;
    int threads;
    Build build;
    std::unique_ptr<Peer> peer = nullptr;
    std::vector<double> build_seconds = {};
};

/// What an entrant does of one set of rays: all of them, or as many as it manages.
struct Run {
    Entrant* entrant;
    std::vector<std::size_t> chosen;  // of the set's rays, whole blocks
    std::vector<Ray> rays;
    std::vector<std::int32_t> answers;
    std::vector<double> seconds = {};
};

std::vector<Entrant> entrants(const RaceOptions& options) {
    std::vector<Entrant> all;
    for (const int threads : options.threads)
        for (const std::string& name : options.peers) all.push_back({name, threads, peer_kind(name).builder(threads)});
    return all;
}

void build(std::vector<Entrant>& all, const Scene& scene, int repetitions) {
    for (int i = 0; i < repetitions; ++i)
        for (Entrant& entrant : all) {
            entrant.peer.reset();
            const auto start = Clock::now();
            entrant.peer = entrant.build(scene);
            entrant.build_seconds.push_back(seconds_since(start));
        }
}

double seconds(const Peer& peer, RayQuestion question, int threads, const std::vector<Ray>& rays,
               std::vector<std::int32_t>& answers) {
    const auto start = Clock::now();
    for_each_piece(rays.size(), 4096, threads, [&](std::size_t begin, std::size_t end) {
        const std::span some(rays.data() + begin, end - begin);
        const std::span triangles(answers.data() + begin, end - begin);
        if (question == RayQuestion::any) peer.any(some, triangles);
        else peer.closest(some, triangles);
    });
    return seconds_since(start);
}

/// Every `share`-th block of rays: neighbours stay together, as they are what makes rays fast.
Run part(Entrant& entrant, const RaySet& set, std::size_t share) {
    constexpr std::size_t block = 64;
    Run run{&entrant, {}, {}, {}};
    const auto& all = set.rays->rays;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i / block % share == 0) {
            run.chosen.push_back(i);
            run.rays.push_back(all[i]);
        }
    run.answers.resize(run.rays.size());
    return run;
}

/// As many rays as the entrant answers in the longest time, by a trial that warms it up, too.
Run suited_run(Entrant& entrant, const RaySet& set, double longest) {
    const std::size_t few = std::max<std::size_t>(1, set.rays->rays.size() / 1024);
    Run trial = part(entrant, set, few);
    const double spent = seconds(*entrant.peer, set.question, entrant.threads, trial.rays, trial.answers);
    const double all = spent * static_cast<double>(set.rays->rays.size()) / static_cast<double>(trial.rays.size());
    return all <= longest ? part(entrant, set, 1) : part(entrant, set, std::min(few, static_cast<std::size_t>(all / longest) + 1));
}

void judge(const Run& run, const RaySet& set, Row& row) {
    for (std::size_t i = 0; i < run.chosen.size(); ++i) {
        const auto exact = set.rays->nearest[run.chosen[i]], found = run.answers[i];
        row.hits += exact != none;
        row.wrong += (exact != none) != (found != none);
        row.other += set.question == RayQuestion::nearest && exact != none && found != none && exact != found;
    }
}

Row row(const Run& run, const RaySet& set) {
    const auto rays = static_cast<double>(run.rays.size());
    Row row{.rays = set.name, .peer = run.entrant->name, .question = set.question, .threads = run.entrant->threads,
            .ray_count = run.rays.size(), .rays_per_second = rays / median(run.seconds),
            .slowest = rays / std::ranges::max(run.seconds), .fastest = rays / std::ranges::min(run.seconds),
            .build_seconds = median(run.entrant->build_seconds), .bytes = run.entrant->peer->bytes()};
    judge(run, set, row);
    return row;
}

}  // namespace

std::vector<Row> race(const std::string& mesh, const RaceOptions& options) {
    const Scene scene = scene_of_mesh(mesh);
    auto all = entrants(options);
    const auto sets = ray_sets(scene, options.rays, options.size);
    build(all, scene, options.repetitions);
    std::vector<Row> rows;
    for (const RaySet& set : sets) {
        std::vector<Run> runs;
        for (Entrant& entrant : all) runs.push_back(suited_run(entrant, set, options.longest));
        for (int i = 0; i < options.repetitions; ++i)
            for (Run& run : runs)
                run.seconds.push_back(seconds(*run.entrant->peer, set.question, run.entrant->threads, run.rays, run.answers));
        for (const Run& run : runs) {
            rows.push_back(row(run, set));
            rows.back().mesh = mesh;
            rows.back().triangles = mesh_of(scene).faces.size();
        }
    }
    return rows;
}

}  // namespace raylab::bench
