#include "refraction.h"

#include "raylab/base/tiles.h"
#include "raylab/geometry/degree.h"
#include "raylab/sampling/sequence.h"

#include <cmath>
#include <numbers>

namespace raylab::recursion {

namespace {

// A ray that arrives at this angle (radians) at a surface of any orientation.
RefractionQuery arriving(double angle, float before, float behind, RandomSequence& random) {
    const Vec3d normal = random.unit_vector(), aside = random.unit_vector_across(normal);
    return {convert<float>(std::sin(angle) * aside - std::cos(angle) * normal), convert<float>(normal), before, behind};
}

template <class Angle>
RefractionWorkload workload(const std::string& name, const std::string& about, float before, float behind,
                            std::size_t queries, const Angle& angle, std::uint64_t seed) {
    RefractionWorkload result{.name = name, .about = about, .data = {}, .queries = {}};
    for (std::size_t i = 0; i < queries; ++i) {
        RandomSequence random(seed, i);
        const double at = angle(random);
        result.queries.push_back(arriving(at, before, behind, random));
    }
    return result;
}

// The direction of light that is not refracted.
Vec3d mirrored(const RefractionQuery& query) {
    const Vec3d d = glm::normalize(convert<double>(query.direction)), n = glm::normalize(convert<double>(query.normal));
    return d - 2 * dot(d, n) * n;
}

// The angle between vectors of approximately unit length; pi where one is NaN.
double angle_between(const Vec3d& a, const Vec3d& b) {
    const double half_chord = glm::length(a - b) / 2;
    return std::isfinite(half_chord) ? 2 * std::asin(std::min(1.0, half_chord)) : std::numbers::pi;
}

}  // namespace

RefractionWorkload at_the_critical_angle(float ior, std::size_t queries, std::uint64_t seed) {
    const double critical = std::asin(1.0 / ior);
    return workload(
        "critical angle", "Within a millionth of a radian of total internal reflection.", ior, 1, queries,
        [=](RandomSequence& random) { return critical + random.between(-1e-6, 1e-6); }, seed);
}

std::vector<RefractionWorkload> refraction_workloads(std::size_t queries, std::uint64_t seed) {
    return {workload(
                "any angle", "From air into glass, at all angles.", 1, 1.5f, queries,
                [](RandomSequence& random) { return random.between(0, 89) * degree; }, seed),
            workload(
                "upright", "Within a ten-thousandth of a radian of the normal.", 1, 1.5f, queries,
                [](RandomSequence& random) { return random.between(0, 1e-4); }, seed),
            workload(
                "grazing", "Within a hundredth of a degree of the surface.", 1, 1.5f, queries,
                [](RandomSequence& random) { return random.between(89.98, 89.99) * degree; }, seed),
            at_the_critical_angle(2.42f, queries, seed)};
}

RefractionTruth::RefractionTruth(const RefractionWorkload& workload, int threads)
    : directions_(workload.queries.size()), mirrored_(workload.queries.size()) {
    for_each_piece(directions_.size(), 256, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            directions_[i] = exact_refraction(workload.queries[i]);
            mirrored_[i] = mirrored(workload.queries[i]);
        }
    });
}

Judgement RefractionTruth::judge(std::span<const std::optional<Vec3d>> answers) const {
    double worst = 0, wrong = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        worst =
            std::max(worst, angle_between(directions_[i].value_or(mirrored_[i]), answers[i].value_or(mirrored_[i])));
        wrong += directions_[i].has_value() != answers[i].has_value();
    }
    return {.error = worst,
            .counts = {{"wrong total internal reflection ppm", 1e6 * wrong / static_cast<double>(answers.size())}}};
}

std::optional<std::size_t> RefractionTruth::first_wrong_decision(std::span<const std::optional<Vec3d>> answers) const {
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (directions_[i].has_value() != answers[i].has_value()) return i;
    return std::nullopt;
}

std::vector<std::optional<Vec3d>> answers_of(const RefractionMethod& method, const RefractionWorkload& workload) {
    std::vector<std::optional<Vec3d>> answers(workload.queries.size());
    method.answer({}, workload.data, workload.queries, answers);
    return answers;
}

Experiment measure_refraction(const ChapterRun& run) {
    Experiment experiment{.question = "refraction",
                          .title = "Where does a refracted ray go on?",
                          .error_axis = "worst angle to the true direction [rad]",
                          .rows = {}};
    auto methods = refraction_methods();
    if (run.is_yours("refracted_direction")) methods.push_back(your_refraction_method());
    for (const auto& workload : refraction_workloads(run.sized<std::size_t>(20'000, 2'000), run.seed)) {
        const RefractionTruth truth(workload, run.threads);
        const auto judge = [&](std::span<const std::optional<Vec3d>> answers) { return truth.judge(answers); };
        for (const auto& method : methods) experiment.rows.push_back(measure(method, workload, judge, run.timing()));
    }
    return experiment;
}

}  // namespace raylab::recursion
