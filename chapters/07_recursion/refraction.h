#pragma once

#include "raylab/experiment/refraction_methods.h"
#include "raylab/report/chapter.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raylab::recursion {

using RefractionWorkload = Workload<std::monostate, RefractionQuery>;

/// Rays at all angles, almost perpendicular, grazing, and within a millionth of a radian of the critical angle.
std::vector<RefractionWorkload> refraction_workloads(std::size_t queries, std::uint64_t seed);

/// Rays within a millionth of a radian of the critical angle, leaving a medium of this index.
RefractionWorkload at_the_critical_angle(float ior, std::size_t queries, std::uint64_t seed);

/// The exact directions in which the rays of a workload continue, computed once for all methods.
class RefractionTruth {
public:
    RefractionTruth(const RefractionWorkload& workload, int threads);

    /// The worst angle between the exact direction and the answer's, refracted or, at total internal reflection,
    /// reflected; and how often that decision was wrong.
    Judgement judge(std::span<const std::optional<Vec3d>> answers) const;

    /// The first ray that is refracted by its answer and not in truth, or the reverse.
    std::optional<std::size_t> first_wrong_decision(std::span<const std::optional<Vec3d>> answers) const;

    /// The exact direction of a ray; absent: total internal reflection.
    const std::optional<Vec3d>& direction(std::size_t ray) const { return directions_[ray]; }

private:
    std::vector<std::optional<Vec3d>> directions_;
    std::vector<Vec3d> mirrored_;
};

/// A method's answers, computed once.
std::vector<std::optional<Vec3d>> answers_of(const RefractionMethod& method, const RefractionWorkload& workload);

/// "Where does a refracted ray go on?": the worst angle against nanoseconds.
Experiment measure_refraction(const ChapterRun& run);

}  // namespace raylab::recursion
