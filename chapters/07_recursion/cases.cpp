#include "cases.h"

#include "refraction.h"
#include "rooms.h"

#include "raylab/tracer/fresnel.h"
#include "raylab/tracer/refracted_direction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab::recursion {

namespace {

constexpr auto by_fresnel = WhittedOptions::Reflectance::fresnel;
constexpr double degree = std::numbers::pi / 180;

double wrong_ppm(const std::string& title, const RefractionWorkload& workload) {
    const auto answers = answers_of(find_method(refraction_methods(), title), workload);
    return judge_refraction(workload, answers).counts.at("wrong total reflection ppm");
}

// A method that must take refraction for total reflection, or the reverse, in at least `least` of a million; 0: never.
CaseRow decides(const std::string& title, float ior, const ChapterRun& run, double least) {
    const double ppm = wrong_ppm(title, at_the_critical_angle(ior, 100'000, run.seed));
    return {fmt::format("{}, index {}", title, ior),
            least > 0 ? fmt::format("wrong in more than {:g} %", least / 1e4) : "never wrong",
            ppm > 0 ? fmt::format("wrong in {:.3g} %", ppm / 1e4) : "never wrong", least > 0 ? ppm > least : ppm == 0};
}

// Fresnel's share towards the critical angle: a number, rising, ending at 1.
CaseRow rises() {
    const double critical = std::asin(1 / 2.42);
    bool as_expected = true;
    double last = 0;
    for (int i = -1000; i <= 1000; ++i) {
        const double share = fresnel(std::cos(critical + i * 1e-9), 2.42, 1);
        as_expected = as_expected && share >= last && share <= 1 && (i <= 0 || share == 1);
        last = share;
    }
    return {"Fresnel's share within 1e-6 rad of the critical angle", "rises to 1, never NaN",
            as_expected ? "rises to 1, never NaN" : "does not", as_expected};
}

StabilityCase tir_edge(const ChapterRun& run) {
    return {"TIR-EDGE", "Rays within a millionth of a radian of the critical angle: refracted, or all reflected?", [run] {
                return std::vector{decides("root, float", 2.42f, run, 5e4), decides("root, factored, float", 1.5f, run, 1e4),
                                   decides("angles, float", 2.42f, run, 5e4), decides("root, double", 2.42f, run, 0),
                                   decides("along the surface, double", 2.42f, run, 0),
                                   decides("along the surface, double", 1.5f, run, 0), rises()};
            }};
}

// Angles just under 90 degrees.
double grazing_angle(std::size_t i, std::size_t count) {
    return (89.98 + 0.01 * static_cast<double>(i) / static_cast<double>(count)) * degree;
}

constexpr std::size_t grazing_rays = 2'000;

// Into a slab of glass and out again, as the tracer does it with a method: the worst angle between the way in and the way
// out; 2: a ray was lost.
double round_trip(const std::string& title) {
    const auto method = find_method(refraction_methods(), title);
    RefractionWorkload in{.name = "in", .about = "", .data = {}, .queries = {}}, out = in;
    for (std::size_t i = 0; i < grazing_rays; ++i) {
        const double angle = grazing_angle(i, grazing_rays);
        in.queries.push_back({convert<float>(Vec3d{std::sin(angle), -std::cos(angle), 0}), {0, 1, 0}, 1, 1.5f});
    }
    for (const auto& direction : answers_of(method, in))
        out.queries.push_back({convert<float>(direction.value_or(Vec3d{0, 0, 0})), {0, 1, 0}, 1.5f, 1});
    const auto answers = answers_of(method, out);
    double worst = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Vec3d before = glm::normalize(convert<double>(in.queries[i].direction));
        worst = std::max(worst, answers[i] ? glm::length(*answers[i] - before) : 2.0);
    }
    return worst;
}

// The same without floats between.
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
    const auto text = [](double turned) { return turned == 2 ? "some rays are lost" : fmt::format("{:.2g} rad", turned); };
    return {"GRAZING", "Into a glass slab and out again at 89.99 degrees: how far is a ray turned?", [text] {
                std::vector<CaseRow> rows;
                for (const std::string title : {"angles, float", "root, float", "along the surface, double"}) {
                    const double turned = round_trip(title);
                    rows.push_back({title + ", floats between", "more than 5e-05 rad", text(turned), turned > 5e-5});
                }
                const double turned = round_trip_in_doubles();
                rows.push_back({"the slot's, doubles all the way", "within 1e-10 rad", text(turned), turned < 1e-10});
                return rows;
            }};
}

StabilityCase hall() {
    return {"HALL-OF-MIRRORS", "Two facing mirrors that glow: the sum of rho^k, which is 1 / (1 - rho).", [] {
                std::vector<CaseRow> rows;
                const double rho = 0.9, truth = hall_of_mirrors_truth(rho);
                const Room room = hall_of_mirrors(rho);
                for (const int depth : {5, 15}) {
                    const double seen = room.brightness({.depth = depth}), cut_off = hall_of_mirrors_truth(rho, depth);
                    rows.push_back({fmt::format("depth {}", depth), fmt::format("too dark: {:.6g} of {:g}", cut_off, truth),
                                    fmt::format("{:.6g}", seen), std::abs(seen - cut_off) < 1e-12 * truth});
                }
                for (const double threshold : {0.01, 0.0001}) {
                    const double lost = truth - room.brightness({.depth = 1000, .threshold = threshold});
                    const double bound = threshold / (1 - rho);
                    rows.push_back({fmt::format("threshold {:g}", threshold), fmt::format("{:g} lost at most", bound),
                                    fmt::format("{:.3g} lost", lost), lost >= 0 && lost <= bound * (1 + 1e-9)});
                }
                return rows;
            }};
}

struct Sight {
    double seen = 0, rays = 0;
    double lost_at_most = 0;  // by what was not followed: nothing is brighter than 1
};

Sight through_panes(int count, const WhittedOptions& options) {
    const RayTree tree = panes(count).tree(options);
    Sight sight{.seen = tree.pixel.x};
    for (const auto& node : tree.nodes) {
        const bool followed = node.ended != Ending::depth && node.ended != Ending::threshold;
        sight.rays += followed;
        if (!followed) sight.lost_at_most += node.weight;
    }
    return sight;
}

CaseRow panes_row(int count, const WhittedOptions& options, const std::string& how) {
    const double truth = panes_truth(count);
    const auto [seen, rays, lost_at_most] = through_panes(count, options);
    const std::string title = fmt::format("{} pane{}, {}", count, count == 1 ? "" : "s", how);
    const std::string sight = fmt::format("{:.9f} with {:.0f} rays", seen, rays);
    if (2 * count >= options.depth) return {title, fmt::format("blind: sees 0 of {:.9f}", truth), sight, seen == 0};
    return {title, fmt::format("{:.9f}, {:.3g} lost at most", truth, lost_at_most), sight,
            truth - seen >= -1e-12 && truth - seen <= lost_at_most + 1e-12};
}

StabilityCase panes_case() {
    return {"PANES", "Through m panes of glass comes T = (1 - r) / (1 + (2 m - 1) r) of the light, all bounces counted.", [] {
                const WhittedOptions deep{.depth = 15, .reflectance = by_fresnel};
                const WhittedOptions adaptive{.depth = 200, .threshold = 1e-4, .reflectance = by_fresnel};
                std::vector<CaseRow> rows;
                for (const int count : {1, 4, 16}) rows.push_back(panes_row(count, deep, "depth 15"));
                for (const int count : {4, 16}) rows.push_back(panes_row(count, adaptive, "threshold 0.0001"));
                return rows;
            }};
}

struct Bombed {
    double rays = 0, seen = 0;
    double lost_at_most = 0;  // by what the threshold cut off
};

Bombed bombed(double threshold) {
    const RayTree tree = glass_chamber(15).tree({.depth = 15, .threshold = threshold, .reflectance = by_fresnel});
    Bombed result{.seen = tree.pixel.x};
    for (const auto& node : tree.nodes) {
        result.rays += node.ended != Ending::depth && node.ended != Ending::threshold;
        if (node.ended == Ending::threshold) result.lost_at_most += node.weight * glass_chamber_brightest(15 - node.depth);
    }
    return result;
}

StabilityCase ray_bomb() {
    return {"RAY-BOMB", "An eye inside the glass of a chamber of 15 glass surfaces: every hit makes two rays of one.", [] {
                const Bombed all = bombed(0);
                std::vector<CaseRow> rows{{"depth 15", "explodes: 2^15 - 1 = 32767 rays", fmt::format("{:.0f} rays", all.rays),
                                           all.rays == 32767}};
                for (const auto& [threshold, budget] : {std::pair{0.01, 200.0}, std::pair{0.001, 1000.0}}) {
                    const Bombed some = bombed(threshold);
                    const double lost = std::abs(all.seen - some.seen);
                    rows.push_back({fmt::format("depth 15, threshold {:g}", threshold),
                                    fmt::format("at most {:.0f} rays, {:.3g} of {:.3g} lost at most", budget,
                                                some.lost_at_most, all.seen),
                                    fmt::format("{:.0f} rays, {:.3g} lost", some.rays, lost),
                                    some.rays <= budget && lost <= some.lost_at_most});
                }
                return rows;
            }};
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    return {tir_edge(run), grazing(), hall(), panes_case(), ray_bomb()};
}

}  // namespace raylab::recursion
