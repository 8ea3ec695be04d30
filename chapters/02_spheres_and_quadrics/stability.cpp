#include "stability.h"

#include "trial.h"

#include "raylab/experiment/ray_sphere/ray_sphere.h"
#include "raylab/geometry/quadric.h"

namespace raylab {

namespace {

WorkloadSize draw_of(const ChapterRun& run) { return {run.sized<std::size_t>(100'000, 10'000), run.seed}; }

// The numbers are smaller, because the oracle takes a tenth of a millisecond for a quadric.
WorkloadSize quadric_draw_of(const ChapterRun& run) { return {run.sized<std::size_t>(20'000, 3'000), run.seed}; }

SphereMethod beginners(const std::string& name, const std::string& number,
                       std::optional<double> (*answer)(const SphereQuery&)) {
    return {name,
            number,
            "what everyone writes first",
            {},
            [answer](const std::any&, auto, std::span<const SphereQuery> queries, auto answers) {
                for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = answer(queries[i]);
            }};
}

// Returns the entry only; it does not consider that a ray may start inside.
std::optional<double> near_root_only(const SphereQuery& query) {
    const RayOf<double> ray = in<double>(query.ray);
    const auto roots =
        stable_roots(along(ray, in<double>(query.sphere)), along(ray, in<double>(query.sphere)).discriminant());
    return roots && contains(ray.range, roots->low) ? std::optional(roots->low) : std::nullopt;
}

// Replaces the floor by the plane that it resembles, in float: through the point of the sphere under the eye.
std::optional<double> plane_in_its_place(const SphereQuery& query) {
    const Vec3d up = glm::normalize(convert<double>(query.ray.origin) - convert<double>(query.sphere.center));
    const Vec3f point = convert<float>(convert<double>(query.sphere.center) + up * double{query.sphere.radius});
    const Vec3f normal = convert<float>(up);
    return dot(point - query.ray.origin, normal) / dot(query.ray.direction, normal);
}

/// Trials with the chapter's methods, and with a student's where there is one.
class Trials {
public:
    explicit Trials(const ChapterRun& run) : run_(run) {
        methods_ = ray_sphere_methods();
        methods_.push_back(beginners("near root only", "double", near_root_only));
        methods_.push_back(beginners("plane in its place", "float", plane_in_its_place));
    }

    SphereTrial trial(SphereWorkload workload) const { return {std::move(workload), methods_, run_.threads}; }

    std::vector<CaseRow> with_yours(std::vector<CaseRow> rows, const SphereTrial& trial) const {
        if (run_.is_yours("nearest_sphere_hit")) rows.push_back(trial.shown(your_sphere_method()));
        return rows;
    }

    WorkloadSize draw() const { return draw_of(run_); }

private:
    ChapterRun run_;
    std::vector<SphereMethod> methods_;
};

std::vector<CaseRow> far_sphere(const Trials& trials) {
    // Fewer queries would not show a share of 200 ppm.
    const SphereTrial far =
        trials.trial(spheres_at(4096, {std::max<std::size_t>(trials.draw().count, 50'000), trials.draw().seed}));
    const SphereTrial farther = trials.trial(spheres_at(1e7, trials.draw()));
    return trials.with_yours(
        {far.more_wrong_than(0.25, "textbook, float"),
         far.more_wrong_than(0.25, "stable, float"),  // its roots are better, but its discriminant is the same
         far.less_wrong_than(2e-4, "reformulated, float"), far.less_wrong_than(2e-4, "factored, float"),
         far.never_wrong("textbook, double"), far.never_wrong("filtered exact, double + exact"),
         farther.more_wrong_than(0.1, "reformulated, float"), farther.more_wrong_than(1e-3, "textbook, double"),
         farther.less_wrong_than(1e-4, "stable, long double"), farther.never_wrong("reformulated, double"),
         farther.never_wrong("filtered exact, double + exact")},
        farther);
}

std::vector<CaseRow> silhouette(const Trials& trials) {
    const SphereTrial trial = trials.trial(silhouettes(trials.draw()));
    return trials.with_yours(
        {trial.more_wrong_than(0.4, "textbook, float"), trial.more_wrong_than(1e-3, "reformulated, float"),
         trial.never_wrong("textbook, double"), trial.never_wrong("filtered exact, double + exact")},
        trial);
}

std::vector<CaseRow> floor(const Trials& trials) {
    const SphereTrial tilted = trials.trial(sphere_floor({.radius = 1e7}, trials.draw()));
    const SphereTrial along_y = trials.trial(sphere_floor({.radius = 1e7, .up = Up::along_y}, trials.draw()));
    const SphereTrial taller =
        trials.trial(sphere_floor({.radius = 1e7, .up = Up::along_y, .eye_height = 1.7}, trials.draw()));
    return trials.with_yours(
        {tilted.off_by_more_than(1, "textbook, float"), tilted.off_by_more_than(0.1, "stable, float"),
         tilted.off_by_more_than(0.1, "reformulated, float"), tilted.off_by_more_than(0.1, "factored, float"),
         along_y.off_by_less_than(1e-4, "factored, float"),  // by luck: eye and center have integer coordinates
         taller.off_by_more_than(0.1, "factored, float"), tilted.off_by_less_than(1e-8, "textbook, double"),
         tilted.off_by_less_than(1e-8, "filtered exact, double + exact"),
         tilted.off_by_less_than(1e-5, "plane in its place, float")},
        tilted);
}

std::vector<CaseRow> tangent(const Trials& trials) {
    const SphereTrial small = trials.trial(tangents(Wholes::small, trials.draw()));
    const SphereTrial large = trials.trial(tangents(Wholes::large, trials.draw()));
    const SphereTrial beside = trials.trial(near_tangents(trials.draw()));
    return trials.with_yours(
        {small.never_wrong("textbook, float"),  // integers below 2^24, so nothing is rounded
         small.more_wrong_than(0.01, "reformulated, float"), beside.more_wrong_than(0.25, "textbook, float"),
         beside.less_wrong_than(0.01, "reformulated, float"), large.more_wrong_than(0.1, "textbook, float"),
         large.never_wrong("textbook, double"), large.more_wrong_than(0.01, "reformulated, double"),
         large.never_wrong("filtered exact, double + exact"), beside.never_wrong("filtered exact, double + exact")},
        large);
}

std::vector<CaseRow> inside_start(const Trials& trials) {
    const SphereTrial trial = trials.trial(inside_starts(trials.draw()));
    return trials.with_yours(
        {trial.more_wrong_than(0.99, "near root only, double"), trial.never_wrong("textbook, float"),
         trial.never_wrong("reformulated, float"), trial.never_wrong("filtered exact, double + exact")},
        trial);
}

std::vector<CaseRow> on_surface(const Trials& trials) {
    const SphereTrial trial = trials.trial(surface_starts(trials.draw()));
    return trials.with_yours(
        {trial.more_wrong_than(0.25, "textbook, float"), trial.more_wrong_than(0.25, "reformulated, float"),
         trial.more_wrong_than(0.25, "factored, float"), trial.never_wrong("textbook, double"),
         trial.never_wrong("filtered exact, double + exact")},
        trial);
}

std::vector<CaseRow> range(const Trials& trials) {
    const SphereTrial tiny = trials.trial(scaled_spheres("tiny", -50, trials.draw()));
    const SphereTrial huge = trials.trial(scaled_spheres("huge", 43, trials.draw()));
    return trials.with_yours(
        {tiny.more_wrong_than(0.25, "textbook, float"),      // b^2 and a c are both 0, which always is a hit
         huge.more_wrong_than(0.5, "textbook, float"),       // both are infinite, which never is a hit
         tiny.never_wrong("reformulated, float"),            // its decisions are right ...
         tiny.off_by_more_than(0.1, "reformulated, float"),  // ... but its t is computed from an underflow
         tiny.never_wrong("textbook, double"), huge.never_wrong("textbook, double"),
         tiny.never_wrong("filtered exact, double + exact"), huge.never_wrong("filtered exact, double + exact")},
        tiny);
}

std::vector<CaseRow> rim(const ChapterRun& run) {
    const QuadricTrial trial(rims(quadric_draw_of(run)), ray_quadric_methods(), run.threads);
    return {trial.more_wrong_than(0.1, "general quadric, float"),
            trial.less_wrong_than(1e-3, "general quadric, double"),
            trial.never_wrong("filtered exact, double + exact")};
}

std::vector<CaseRow> apex(const ChapterRun& run) {
    const QuadricTrial trial(apexes(quadric_draw_of(run)), ray_quadric_methods(), run.threads);
    return {trial.more_wrong_than(0.1, "general quadric, float"),
            trial.more_wrong_than(0.05, "general quadric, double"),
            trial.never_wrong("filtered exact, double + exact")};
}

std::vector<CaseRow> far_quadric(const ChapterRun& run) {
    const QuadricTrial trial(quadrics_at(1000, QuadricKind::any, quadric_draw_of(run)), ray_quadric_methods(),
                             run.threads);
    return {trial.more_wrong_than(0.01, "general quadric, float"),
            trial.less_wrong_than(1e-4, "general quadric, double"),
            trial.never_wrong("filtered exact, double + exact")};
}

}  // namespace

std::vector<StabilityCase> stability_cases(const ChapterRun& run) {
    const auto of_spheres = [&run](std::vector<CaseRow> (*rows)(const Trials&)) {
        return [run, rows] { return rows(Trials(run)); };
    };
    const auto of_quadrics = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {
        {"FAR-SPHERE", "A sphere 4096 and 10 million radii away: b^2 and a c agree in nearly all digits.",
         of_spheres(far_sphere)},
        {"SILHOUETTE", "A sphere 100 radii away, passed within a ten-thousandth of its silhouette.",
         of_spheres(silhouette)},
        {"SPHERE-FLOOR", "A sphere of radius 1e7 as a floor, seen from 1 above it: |f|^2 and r^2 agree.",
         of_spheres(floor)},
        {"TANGENT", "Rays that touch a sphere exactly, in whole numbers, and a sphere one float smaller.",
         of_spheres(tangent)},
        {"INSIDE-START", "Rays that start inside a sphere and must hit on their way out.", of_spheres(inside_start)},
        {"ON-SURFACE", "Rays that leave a sphere from its surface; rounding put them a hair inside or outside.",
         of_spheres(on_surface)},
        {"SPHERE-RANGE", "A scene of size 1e-15, and one of size 1e13: fourth powers leave the range of floats.",
         of_spheres(range)},
        {"QUADRIC-RIM", "Rays aimed at the circle in which a cylinder's side and cap meet.", of_quadrics(rim)},
        {"QUADRIC-APEX", "Rays aimed at the apex of a cone.", of_quadrics(apex)},
        {"FAR-QUADRIC", "Quadrics of all kinds from 1000 away.", of_quadrics(far_quadric)},
    };
}

}  // namespace raylab
