#include "cases.h"

#include "case_examples.h"
#include "refraction.h"

#include "raylab/base/number_text.h"
#include "raylab/geometry/degree.h"
#include "raylab/tracer/refracted_direction.h"
#include "raylab/tracer/shading/fresnel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::recursion {

namespace {

// Rays about the critical angle of a surface to air, with their exact directions.
class CriticalAngle {
public:
    CriticalAngle(float ior, const ChapterRun& run)
        : ior_(ior), rays_(at_the_critical_angle(ior, 100'000, run.seed)), truth_(rays_, run.threads) {}

    // A row for a method that must mistake refraction for total internal reflection, or the reverse, in at least
    // `least` of a million; 0: never.
    CaseRow decides(const std::string& title, double smallest) const {
        const auto answers = answers_of(find_method(refraction_methods(), title), rays_);
        const double ppm = truth_.judge(answers).counts.at("wrong total internal reflection ppm");
        CaseRow row{fmt::format("{}, index {}", title, ior_),
                    smallest > 0 ? "fails: wrong in more than " + share_text(smallest / 1e6) : "holds: never wrong",
                    ppm > 0 ? "wrong in " + share_text(ppm / 1e6) : "never wrong",
                    smallest > 0 ? ppm > smallest : ppm == 0};
        if (const auto wrong = truth_.first_wrong_decision(answers))
            row.example = example_at_critical_angle(rays_.queries[*wrong], truth_.direction(*wrong), answers[*wrong]);
        return row;
    }

private:
    float ior_;
    RefractionWorkload rays_;
    RefractionTruth truth_;
};

// A row for Fresnel's reflectance towards the critical angle: it must be a number, increase, and end at 1.
CaseRow rises() {
    const double critical = std::asin(1 / 2.42);
    bool as_expected = true;
    double last = 0;
    for (int i = -1000; i <= 1000; ++i) {
        const double share = fresnel(std::cos(critical + i * 1e-9), 2.42, 1);
        as_expected = as_expected && share >= last && share <= 1 && (i <= 0 || share == 1);
        last = share;
    }
    return {"Fresnel's share within 1e-6 rad of the critical angle", "holds: rises to 1, never NaN",
            as_expected ? "rises to 1, never NaN" : "does not", as_expected};
}

StabilityCase tir_edge(const ChapterRun& run) {
    return {"TIR-EDGE",
            "Rays within a millionth of a radian of the critical angle: refracted, or all "
            "reflected?",
            [run] {
                const CriticalAngle diamond(2.42f, run), glass(1.5f, run);
                return std::vector{diamond.decides("root, float", 5e4),
                                   diamond.decides("root, factored, float", 5e4),
                                   diamond.decides("angles, float", 5e4),
                                   diamond.decides("along the surface, float", 5e3),
                                   diamond.decides("root, double", 0),
                                   diamond.decides("along the surface, double", 0),
                                   glass.decides("along the surface, double", 0),
                                   rises()};
            }};
}

// An angle slightly below 90 degrees.
double grazing_angle(std::size_t i, std::size_t count) {
    return (89.98 + 0.01 * static_cast<double>(i) / static_cast<double>(count)) * degree;
}

constexpr std::size_t grazing_rays = 2'000;

// What a ray does that goes through a slab of glass: the directions inside and behind it, and the angle between those
// before and behind; 2 where the ray was lost.
struct RoundTrip {
    RefractionQuery before;
    Vec3d inside;
    std::optional<Vec3d> behind;
    double turned = 0;
};

// The ray that a method, with floats between, turns most, as the tracer does it.
RoundTrip worst_round_trip(const std::string& title) {
    const auto method = find_method(refraction_methods(), title);
    RefractionWorkload in{.name = "in", .about = "", .data = {}, .queries = {}}, out = in;
    for (std::size_t i = 0; i < grazing_rays; ++i) {
        const double angle = grazing_angle(i, grazing_rays);
        in.queries.push_back({convert<float>(Vec3d{std::sin(angle), -std::cos(angle), 0}), {0, 1, 0}, 1, 1.5f});
    }
    const auto inside = answers_of(method, in);
    for (const auto& direction : inside)
        out.queries.push_back({convert<float>(direction.value_or(Vec3d{0, 0, 0})), {0, 1, 0}, 1.5f, 1});
    const auto behind = answers_of(method, out);
    RoundTrip worst{};
    for (std::size_t i = 0; i < behind.size(); ++i) {
        const Vec3d before = glm::normalize(convert<double>(in.queries[i].direction));
        const double turned = behind[i] ? glm::length(*behind[i] - before) : 2.0;
        if (turned > worst.turned) worst = {in.queries[i], inside[i].value_or(Vec3d{0, 0, 0}), behind[i], turned};
    }
    return worst;
}

// The same without rounding to floats in between.
double round_trip_in_doubles() {
    double worst = 0;
    for (std::size_t i = 0; i < grazing_rays; ++i) {
        const double angle = grazing_angle(i, grazing_rays);
        const Vec3d before{std::sin(angle), -std::cos(angle), 0};
        const auto inside = refracted_direction(before, {0, 1, 0}, 1, 1.5);
        const auto behind = inside ? refracted_direction(*inside, {0, 1, 0}, 1.5, 1) : std::nullopt;
        worst = std::max(worst, behind ? glm::length(*behind - before) : 2.0);
    }
    return worst;
}

StabilityCase grazing() {
    const auto text = [](double turned) {
        return turned == 2 ? "some rays are lost" : fmt::format("{:.2g} rad", turned);
    };
    return {"GRAZING", "Into a glass slab and out again at 89.99 degrees: how far is a ray turned?", [text] {
                std::vector<CaseRow> rows;
                for (const std::string title : {"angles, float", "root, float", "along the surface, double"}) {
                    const auto [before, inside, behind, turned] = worst_round_trip(title);
                    rows.push_back({title + ", floats between", "fails: more than 5e-05 rad", text(turned),
                                    turned > 5e-5, example_through_slab(before, inside, behind)});
                }
                const double turned = round_trip_in_doubles();
                rows.push_back(
                    {"the slot's, doubles all the way", "holds: within 1e-10 rad", text(turned), turned < 1e-10});
                return rows;
            }};
}

}  // namespace

std::vector<StabilityCase> refraction_cases(const ChapterRun& run) { return {tir_edge(run), grazing()}; }

}  // namespace raylab::recursion
