#include "pixel_samples.h"

#include "coverage_workloads.h"

#include "raylab/geometry/intersect/intersect.h"
#include "raylab/report/finding.h"
#include "raylab/sampling/pixel_samples.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>

namespace raylab::ray_generation {

namespace {

using CoverageMethod = Method<Triangle, PixelQuery, double>;

constexpr std::array patterns{SamplePattern::center, SamplePattern::corner, SamplePattern::jittered,
                              SamplePattern::random};

std::string name_of(SamplePattern pattern) {
    switch (pattern) {
        case SamplePattern::center:
            return "centre";
        case SamplePattern::corner:
            return "corner";
        case SamplePattern::jittered:
            return "jittered";
        case SamplePattern::random:
            return "random";
    }
    return {};
}

// The formula README (2), written out.
Ray formula_ray(const CameraFrame& frame, double x, double y) {
    const double across = (2 * x / frame.image.width - 1) * frame.half_width;
    const double upward = (1 - 2 * y / frame.image.height) * frame.half_height;
    const Vec3d direction = glm::normalize(frame.forward + across * frame.right + upward * frame.up);
    return {.origin = convert<float>(frame.eye), .direction = convert<float>(direction)};
}

// The share of a pixel's rays that hit, decided exactly, so that only the samples cause an error.
template <class PixelRay>
CoverageMethod coverage_by(const std::string& name, const PixelRay& pixel_ray, const CameraFrame& frame,
                           const PixelSamples& samples) {
    const auto answer = [pixel_ray, frame, samples](const std::any&, std::span<const Triangle> triangles,
                                                    std::span<const PixelQuery> queries, std::span<double> covered) {
        DecisionCounts decisions;
        for (std::size_t q = 0; q < queries.size(); ++q) {
            const auto [triangle, x, y] = queries[q];
            int hits = 0;
            for (int i = 0; i < samples.count(); ++i) {
                const PixelPoint at = pixel_sample(samples, q, i);
                hits += intersect(pixel_ray(frame, x + at.x, y + at.y), triangles[triangle], decisions).has_value();
            }
            covered[q] = 1.0 * hits / samples.count();
        }
    };
    return {.name = name, .number = "exact", .source = "", .prepare = {}, .answer = answer};
}

Judgement judge(std::span<const double> covered, std::span<const double> truth) {
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        squares += (covered[i] - truth[i]) * (covered[i] - truth[i]);
        sum += covered[i] - truth[i];
    }
    const auto count = static_cast<double>(truth.size());
    return {.error = std::sqrt(squares / count), .counts = {{"mean error", sum / count}}};
}

}  // namespace

Experiment measure_pixel_samples(const ChapterRun& run) {
    const CameraFrame frame = coverage_camera();
    Experiment experiment{.question = "pixel_samples",
                          .title = "How much of a pixel does a triangle cover?",
                          .error_axis = "RMS error of the covered share",
                          .rows = {},
                          .answer = answer_within(0.05)};
    for (const Coverage& workload : coverage_workloads(run)) {
        const std::vector<double> truth = true_coverages(workload);
        const auto add = [&](const CoverageMethod& method, const PixelSamples& samples) {
            auto row = measure(
                method, workload, [&](std::span<const double> covered) { return judge(covered, truth); }, run.timing());
            row.knob = std::to_string(samples.count()) + (samples.count() == 1 ? " ray" : " rays");
            row.counts["rays a pixel"] = samples.count();
            experiment.rows.push_back(row);
        };
        for (const SamplePattern pattern : patterns)
            for (int per_side = 1; per_side <= run.sized(16, 8); per_side *= 2) {
                const PixelSamples samples{pattern, per_side, run.seed};
                add(coverage_by(name_of(pattern), formula_ray, frame, samples), samples);
            }
        // With a student's picture_ray(), only samples at pixel centers show whether it is right.
        for (int per_side = 1; run.is_yours("picture_ray") && per_side <= run.sized(16, 8); per_side *= 2)
            add(coverage_by("yours", eye_ray, frame, {.per_side = per_side}), {.per_side = per_side});
    }
    return experiment;
}

namespace {

// The errors of N = 1, 4, 16, 64, 256 rays a pixel.
std::vector<double> errors_of(const Coverage& workload, SamplePattern pattern, std::uint64_t seed) {
    const std::vector<double> truth = true_coverages(workload);
    std::vector<double> covered(truth.size()), errors;
    for (int per_side = 1; per_side <= 16; per_side *= 2) {
        const auto method = coverage_by("", formula_ray, coverage_camera(), {pattern, per_side, seed});
        method.answer({}, workload.data, workload.queries, covered);
        errors.push_back(judge(covered, truth).error);
    }
    return errors;
}

// The slope of log error over log N, by least squares.
double slope(const std::vector<double>& errors) {
    double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    const auto count = static_cast<double>(errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double x = static_cast<double>(i) * std::log(4), y = std::log(errors[i]);
        sum_x += x, sum_y += y, sum_xx += x * x, sum_xy += x * y;
    }
    return (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
}

}  // namespace

std::vector<std::string> sample_error_header() {
    return {"N", "centres of a grid", "corners of a grid", "jittered", "random"};
}

std::vector<std::vector<std::string>> sample_error_rows(const ChapterRun& run) {
    const Coverage slanted = coverage_workloads(run).front();
    std::vector<std::vector<std::string>> rows{{"1"}, {"16"}, {"256"}, {"falls like"}};
    for (const SamplePattern pattern : patterns) {
        const auto errors = errors_of(slanted, pattern, run.seed);
        for (std::size_t i = 0; i < 3; ++i) rows[i].push_back(fmt::format("{:#.2g}", errors[2 * i]));
        rows[3].push_back(fmt::format("N^{:.2f}", slope(errors)));
    }
    return rows;
}

StabilityCase sample_slope(const ChapterRun& run) {
    const auto rows = [run] {
        const std::vector<Coverage> all = coverage_workloads(run);
        std::vector<CaseRow> result;
        const auto add = [&](const Coverage& workload, SamplePattern pattern, double theory) {
            const double measured = slope(errors_of(workload, pattern, run.seed));
            result.push_back({fmt::format("{}, {}", name_of(pattern), workload.name),
                              fmt::format("holds: N^{} within 0.08", theory), fmt::format("N^{:.3f}", measured),
                              std::abs(measured - theory) <= 0.08});
        };
        add(all[0], SamplePattern::random, -0.5);
        add(all[0], SamplePattern::jittered, -0.75);
        add(all[1], SamplePattern::center, -0.5);
        return result;
    };
    return {"SAMPLE-SLOPE",
            "Independent samples converge slowly, stratified ones faster, a grid not where edges "
            "follow it.",
            rows};
}

}  // namespace raylab::ray_generation
