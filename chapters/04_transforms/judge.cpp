#include "judge.h"

#include "raylab/base/tiles.h"
#include "raylab/geometry/oracle/oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab::transforms {

namespace {

// The angle between unit vectors; it is accurate for small angles too, for which the cosine is not.
double angle(const Vec3d& a, const Vec3d& b) {
    const double half_chord = glm::length(a - b) / 2;
    return std::isfinite(half_chord) ? 2 * std::asin(std::min(1.0, half_chord)) : std::numbers::pi;
}

}  // namespace

std::vector<std::optional<double>> truth(const SphereWorkload& workload, int threads) {
    const Shape sphere = Sphere{{0, 0, 0}, 1};
    std::vector<std::optional<double>> truths(workload.queries.size());
    for_each_piece(truths.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [ray, which] = workload.queries[i];
            const auto answer = oracle::intersect(in<double>(ray), sphere, workload.data[which]);
            if (answer.hit()) truths[i] = answer.t->nearest();
        }
    });
    return truths;
}

Judgement judge_hits(std::span<const std::optional<double>> truth, std::span<const std::optional<double>> answers) {
    double misses = 0, false_hits = 0, worst = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        misses += truth[i] && !answers[i];
        false_hits += !truth[i] && answers[i];
        if (truth[i] && answers[i]) worst = std::max(worst, std::abs(*answers[i] - *truth[i]) / *truth[i]);
    }
    const double per_million = 1e6 / static_cast<double>(truth.size());
    return {.error = (misses + false_hits) * per_million,
            .error_bound = 3 * per_million,
            .counts = {{"miss ppm", misses * per_million},
                       {"false hit ppm", false_hits * per_million},
                       {"worst relative error of t", worst}}};
}

std::vector<Vec3d> truth(const NormalWorkload& workload) {
    std::vector<Vec3d> truths;
    for (const auto& query : workload.queries) truths.push_back(exact_normal(query));
    return truths;
}

Judgement judge_normals(std::span<const Vec3d> truth, std::span<const Vec3d> answers) {
    double worst = 0, inward = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        worst = std::max(worst, angle(truth[i], answers[i]));
        inward += !(dot(truth[i], answers[i]) > 0);
    }
    return {.error = worst, .counts = {{"inward ppm", 1e6 * inward / static_cast<double>(truth.size())}}};
}

}  // namespace raylab::transforms
