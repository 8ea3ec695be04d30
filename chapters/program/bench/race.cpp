#include "race.h"

#include "processors.h"
#include "timings.h"

#include "raylab/base/tiles.h"
#include "raylab/sampling/random.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <optional>
#include <span>

namespace raylab::bench {

namespace {

/// Measures the time since its construction.
class Stopwatch {
public:
    explicit Stopwatch(Seconds clock) : clock_(clock == Seconds::wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID) {}
    double seconds() const { return now() - start_; }

private:
    double now() const {
        timespec time;
        clock_gettime(clock_, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }
    clockid_t clock_;
    double start_ = now();
};

/// A peer that takes part with a number of threads.
struct Entrant {
    std::string name;
    int threads;
    Build build = {};
    std::unique_ptr<Peer> peer = nullptr;
    Timings builds = {};
};

/// The rays of one set that an entrant traces: all of them, or as many as it manages in time.
struct Run {
    Entrant* entrant;
    std::vector<std::size_t> chosen;  // indices into the set, in whole blocks
    std::vector<Ray> rays;
    std::vector<std::int32_t> answers;
    Timings timings = {};
};

std::vector<Entrant> entrants(const RaceOptions& options) {
    std::vector<Entrant> all;
    for (const int threads : options.threads)
        for (const std::string& name : options.peers) all.push_back({name, threads});
    return all;
}

// Where numbers of threads are compared, one thread takes the processors in turns: of a virtual machine's one may be a
// third slower than another, and what two threads gain would be a matter of where the one had stood.
std::optional<int> processor_of_turn(int turn, const Entrant& entrant, const RaceOptions& options) {
    if (options.threads.size() == 1 || entrant.threads > 1) return {};
    const std::vector<int> all = usable_processors();
    if (all.empty()) return {};
    return all[static_cast<std::size_t>(turn) % all.size()];
}

void build_in_turns(std::span<Entrant* const> those, const Scene& scene, const RaceOptions& options) {
    for (Entrant* entrant : those) entrant->build = peer_kind(entrant->name).builder(entrant->threads);
    for (int i = 0; i < options.repetitions; ++i)
        for (Entrant* entrant : those) {
            entrant->peer.reset();
            const auto processor = processor_of_turn(i, *entrant, options);
            const OnProcessor bound(processor);
            const Stopwatch watch(options.clock);
            entrant->peer = entrant->build(scene);
            entrant->builds.add(processor, watch.seconds());
        }
}

// All take turns; but of those that share the process's threads, fewer threads build first.
void build(std::vector<Entrant>& all, const Scene& scene, const RaceOptions& options) {
    const bool do_share = std::ranges::any_of(options.peers, [](const std::string& peer) {
        return peer_kind(peer).threads == PeerKind::Threads::of_the_process;
    });
    std::map<int, std::vector<Entrant*>> rounds;
    for (Entrant& entrant : all) rounds[do_share ? entrant.threads : 0].push_back(&entrant);
    for (const auto& [threads, those] : rounds) build_in_turns(those, scene, options);
}

double seconds(Run& run, RayQuestion question, Seconds clock) {
    const Peer& peer = *run.entrant->peer;
    const Stopwatch watch(clock);
    for_each_piece(run.rays.size(), 4096, run.entrant->threads, [&](std::size_t begin, std::size_t end) {
        const std::span rays(run.rays.data() + begin, end - begin);
        const std::span answers(run.answers.data() + begin, end - begin);
        if (question == RayQuestion::any)
            peer.any(rays, answers);
        else
            peer.closest(rays, answers);
    });
    return watch.seconds();
}

/// One of each `share` blocks of rays. Neighbouring rays stay together, because coherence is what makes them fast; and
/// which one it is, is left to chance: every sixteenth would lie at the left edge of a picture of 1024 pixels.
Run part(Entrant& entrant, const RaySet& set, std::size_t share) {
    constexpr std::size_t block = 64;
    Run run{&entrant, {}, {}, {}};
    const auto& all = set.rays->rays;
    const std::size_t blocks = (all.size() + block - 1) / block, group = std::min(share, blocks);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t number = i / block;
        if (number % group == random_bits({.pixel = number / group}) % group) {
            run.chosen.push_back(i);
            run.rays.push_back(all[i]);
        }
    }
    run.answers.resize(run.rays.size());
    return run;
}

/// As many rays as the entrant answers in the longest time, estimated by a trial that is also the warm-up.
Run suited_run(Entrant& entrant, const RaySet& set, const RaceOptions& options) {
    const std::size_t few = std::max<std::size_t>(1, set.rays->rays.size() / 1024);
    Run trial = part(entrant, set, few);
    const double spent = seconds(trial, set.question, options.clock);
    const double all = spent * static_cast<double>(set.rays->rays.size()) / static_cast<double>(trial.rays.size());
    if (all <= options.longest) return part(entrant, set, 1);
    return part(entrant, set, std::min(few, static_cast<std::size_t>(all / options.longest) + 1));
}

void judge(const Run& run, const RaySet& set, Row& row) {
    for (std::size_t i = 0; i < run.chosen.size(); ++i) {
        const auto exact = set.rays->nearest[run.chosen[i]], found = run.answers[i];
        row.hits += exact != none;
        row.wrong += (exact != none) != (found != none);
        row.other += set.question == RayQuestion::nearest && exact != none && found != none && exact != found;
    }
}

/// The work for a sixteenth of the rays, or for fewer where the run has fewer.
Work work(const Run& run, const RaySet& set) {
    const bool all = run.rays.size() == set.rays->rays.size();
    const Run some =
        part(*run.entrant, set, all ? 16 : std::max<std::size_t>(16, set.rays->rays.size() / run.rays.size()));
    const auto counted = run.entrant->peer->counts(some.rays, set.question);
    if (!counted) return {};
    const auto mean = [&](std::uint64_t count) {
        return static_cast<double>(count) / static_cast<double>(some.rays.size());
    };
    return {mean(counted->steps), mean(counted->box_tests), mean(counted->primitive_tests),
            mean(counted->exact_decisions)};
}

Row row(const Run& run, const RaySet& set) {
    const auto rays = static_cast<double>(run.rays.size());
    Row row{.rays = set.name,
            .peer = run.entrant->name,
            .question = set.question,
            .threads = run.entrant->threads,
            .ray_count = run.rays.size(),
            .rays_per_second = rays / run.timings.typical(),
            .slowest = rays / run.timings.longest(),
            .fastest = rays / run.timings.shortest(),
            .build_seconds = run.entrant->builds.typical(),
            .bytes = run.entrant->peer->bytes(),
            .work = work(run, set)};
    judge(run, set, row);
    return row;
}

}  // namespace

std::vector<Row> race(const std::string& mesh, const RaceOptions& options) {
    const Scene scene = scene_of_mesh(mesh);
    auto all = entrants(options);
    const auto sets = ray_sets(scene, options.rays, options.size);
    build(all, scene, options);
    std::vector<Row> rows;
    for (const RaySet& set : sets) {
        std::vector<Run> runs;
        for (Entrant& entrant : all) runs.push_back(suited_run(entrant, set, options));
        for (int i = 0; i < options.repetitions; ++i)
            for (Run& run : runs) {
                const auto processor = processor_of_turn(i, *run.entrant, options);
                const OnProcessor bound(processor);
                run.timings.add(processor, seconds(run, set.question, options.clock));
            }
        for (const Run& run : runs) {
            rows.push_back(row(run, set));
            rows.back().mesh = mesh;
            rows.back().triangles = mesh_of(scene).faces.size();
        }
    }
    return rows;
}

}  // namespace raylab::bench
