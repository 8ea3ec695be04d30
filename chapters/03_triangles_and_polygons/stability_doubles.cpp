#include "stability.h"

#include "raylab/base/tiles.h"
#include "raylab/experiment/measure/wrong_decisions.h"
#include "raylab/experiment/ray_triangle/moeller_trumbore.h"
#include "raylab/experiment/ray_triangle/pluecker.h"
#include "raylab/experiment/ray_triangle/watertight.h"
#include "raylab/geometry/oracle/cgal_ray.h"
#include "raylab/geometry/oracle/oracle.h"
#include "raylab/geometry/predicate/triangle_intersection.h"
#include "raylab/number/dyadic.h"
#include "raylab/number/enclosure.h"
#include "raylab/report/case_drawings.h"
#include "raylab/sampling/sequence.h"

#include <fmt/format.h>

#include <atomic>
#include <functional>
#include <limits>
#include <vector>

namespace raylab {

namespace {

struct Pair {
    RayOf<double> ray;
    TriangleOf<double> triangle;
};

constexpr Interval<double> ahead{0, std::numeric_limits<double>::infinity()};

/// A ray aimed at an edge; every number is a double with all its bits.
Pair edge_shot_in_double(std::uint64_t seed, std::size_t i) {
    RandomSequence random(seed, i);
    const Vec3d a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
    const Vec3d origin = 3.0 * random.in_cube();
    return {{origin, a + random.next() * (b - a) - origin, ahead}, {a, b, c}};
}

/// The same numbers rounded to floats: every decision is about other numbers, and each can be decided in double.
Pair snapped(const Pair& pair) {
    const auto snap = [](const Vec3d& v) { return convert<double>(convert<float>(v)); };
    const auto& [a, b, c] = pair.triangle;
    return {{snap(pair.ray.origin), snap(pair.ray.direction), ahead}, {snap(a), snap(b), snap(c)}};
}

/// The filtered decision on doubles: enclosures first, exact numbers where those do not decide.
template <Scalar T>
std::optional<bool> decided_in(const Pair& pair) {
    const auto relative = [&](const Vec3d& v) { return convert<T>(v) - convert<T>(pair.ray.origin); };
    const auto& [a, b, c] = pair.triangle;
    Signs<T> signs;
    const auto found = crossing<T>(convert<T>(pair.ray.direction), {relative(a), relative(b), relative(c)},
                                   Interval<float>{0, std::numeric_limits<float>::infinity()}, signs);
    return signs.undecided() ? std::nullopt : std::optional(found.has_value());
}

using Decide = std::function<bool(const Pair&)>;

struct Count {
    std::size_t wrong = 0, of = 0;
    double share() const { return static_cast<double>(wrong) / static_cast<double>(of); }
};

bool none(const Count& count) { return count.wrong == 0; }

std::string in_words(const Count& count) { return fmt::format("{} of {} wrong", count.wrong, count.of); }

/// Pairs with the oracle's answer to each, computed once for all methods.
class JudgedPairs {
public:
    JudgedPairs(std::vector<Pair> pairs, int threads) : pairs_(std::move(pairs)), threads_(threads) {
        truth_ = ask_oracle(pairs_.size(), threads,
                            [&](std::size_t i) { return oracle::intersect(pairs_[i].ray, pairs_[i].triangle); });
    }

    Count count_wrong(const Decide& decide) const {
        std::atomic<std::size_t> wrong = 0;
        for_each_piece(pairs_.size(), 256, threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) wrong += decide(pairs_[i]) != truth_[i].hit();
        });
        return {wrong, pairs_.size()};
    }

    /// A row whose example is the first pair that is decided wrongly.
    CaseRow row(const std::string& title, const std::string& expected, const Decide& decide,
                const std::function<bool(const Count&)>& expects) const {
        const Count wrong = count_wrong(decide);
        CaseRow row{title, expected, in_words(wrong), expects(wrong)};
        for (std::size_t i = 0; i < pairs_.size() && wrong.wrong > 0 && !row.example; ++i)
            if (decide(pairs_[i]) != truth_[i].hit()) row.example = example(i);
        return row;
    }

private:
    CaseExample example(std::size_t i) const {
        const auto& [ray, triangle] = pairs_[i];
        const auto words = [](const Vec3d& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); };
        return {"ray from " + words(ray.origin) + " along " + words(ray.direction) + ", triangle " + words(triangle.a) +
                    ", " + words(triangle.b) + ", " + words(triangle.c),
                seen_along(ray, {triangle}, truth_[i].hit() ? "In truth it hits." : "In truth it misses.")};
    }

    std::vector<Pair> pairs_;
    int threads_;
    Truth truth_;
};

std::vector<Pair> pairs_of(const ChapterRun& run, const std::function<Pair(std::size_t)>& make) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < run.sized<std::size_t>(100'000, 10'000); ++i) pairs.push_back(make(i));
    return pairs;
}

CaseRow filtered_on_doubles(const JudgedPairs& pairs) {
    std::atomic<std::size_t> left_open = 0;
    const auto decide = [&](const Pair& pair) {
        if (const auto sure = decided_in<Enclosure>(pair)) return *sure;
        ++left_open;
        return *decided_in<Dyadic>(pair);
    };
    const Count wrong = pairs.count_wrong(decide);
    const double share = static_cast<double>(left_open) / static_cast<double>(wrong.of);
    return {"filtered exact, on doubles", "holds: none wrong, but more than 90 % are left to exact arithmetic",
            fmt::format("{}, {:.1f} % left to exact arithmetic", in_words(wrong), 100 * share),
            wrong.wrong == 0 && share > 0.9};
}

}  // namespace

StabilityCase double_input(const ChapterRun& run) {
    return {
        "DOUBLE-INPUT",
        "Edge shots in which rays and vertices use all bits of a double: double methods now fail as float "
        "methods do on floats.",
        [run] {
            const auto shot = [&](std::size_t i) { return edge_shot_in_double(run.seed, i); };
            const JudgedPairs doubles(pairs_of(run, shot), run.threads);
            const JudgedPairs floats(pairs_of(run, [&](std::size_t i) { return snapped(shot(i)); }), run.threads);
            struct Named {
                std::string name;
                Decide decide;
            };
            const std::vector<Named> methods = {
                {"Moeller-Trumbore, double",
                 [](const Pair& p) { return moeller_trumbore(p.ray, p.triangle).has_value(); }},
                {"Pluecker, double", [](const Pair& p) { return pluecker(p.ray, p.triangle).has_value(); }},
                {"watertight, double", [](const Pair& p) { return watertight(p.ray, p.triangle).has_value(); }}};
            std::vector<CaseRow> rows;
            for (const auto& [name, decide] : methods)
                rows.push_back(doubles.row(name + ": doubles", "fails: more than 10 % wrong", decide,
                                           [](const Count& wrong) { return wrong.share() > 0.1; }));
            for (const auto& [name, decide] : methods)
                rows.push_back(floats.row(name + ": the same, snapped to floats", "holds: none wrong", decide, none));
            rows.push_back(filtered_on_doubles(doubles));
            return rows;
        }};
}

StabilityCase epick_ray(const ChapterRun& run) {
    return {"EPICK-RAY",
            "The oracle's own test: CGAL's quick kernel keeps a second point, origin + direction, rounded, so its "
            "ray is another one where the direction is short.",
            [run] {
                const auto shots = [&](double length) {
                    return pairs_of(run, [&, length](std::size_t i) {
                        Pair pair = snapped(edge_shot_in_double(run.seed, i));
                        pair.ray.direction *= length / glm::length(pair.ray.direction);
                        return pair;
                    });
                };
                const auto says = [](oracle::CgalKernel kernel) {
                    return [kernel](const Pair& pair) {
                        return oracle::cgal_do_intersect(kernel, pair.ray, pair.triangle);
                    };
                };
                std::vector<CaseRow> rows;
                for (const double length : {1e-8, 1e-20}) {
                    const JudgedPairs pairs(shots(length), run.threads);
                    rows.push_back(pairs.row(fmt::format("CGAL, quick kernel: |D| = {}", length),
                                             "fails: more than 1 % wrong", says(oracle::CgalKernel::epick),
                                             [](const Count& wrong) { return wrong.share() > 0.01; }));
                    rows.push_back(pairs.row(fmt::format("CGAL, exact kernel: |D| = {}", length), "holds: none wrong",
                                             says(oracle::CgalKernel::epeck), none));
                }
                return rows;
            }};
}

}  // namespace raylab
