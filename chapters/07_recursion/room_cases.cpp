#include "cases.h"

#include "rooms.h"

#include "raylab/tracer/followed_branches.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::recursion {

namespace {

constexpr auto by_fresnel = WhittedOptions::Reflectance::fresnel;

// What an eye sees in the hall if each ray is followed only while it may bring more than the least: all colours are
// known there, so the decision alone is asked.
double hall_by_worth(double rho, double least) {
    double seen = 0, weight = 1;
    for (int levels = 999; weight > 0 && levels >= 0; --levels) {
        seen += weight;
        weight = followed_branches({weight, rho, 0, levels, 1, rho, least}).reflected;
    }
    return seen;
}

CaseRow worth_row(double least, const ChapterRun& run) {
    const double rho = 0.9, lost = hall_of_mirrors_truth(rho) - hall_by_worth(rho, least);
    const std::string observed = fmt::format("{:.3g} lost", lost);
    if (run.is_yours("followed_branches")) return {"yours", "nothing: shown, not judged", observed, true};
    return {fmt::format("worth {:g}", least), fmt::format("holds: {:g} lost at most", least), observed,
            lost >= 0 && lost <= least * (1 + 1e-9)};
}

StabilityCase hall(const ChapterRun& run) {
    return {"HALL-OF-MIRRORS", "Two facing mirrors that glow: the sum of rho^k, which is 1 / (1 - rho).", [run] {
                std::vector<CaseRow> rows;
                const double rho = 0.9, truth = hall_of_mirrors_truth(rho);
                const Room room = hall_of_mirrors(rho);
                for (const int depth : {5, 15}) {
                    const double seen = room.brightness({.depth = depth}), cut_off = hall_of_mirrors_truth(rho, depth);
                    rows.push_back({fmt::format("depth {}", depth),
                                    fmt::format("fails: too dark, {:.6g} of {:g}", cut_off, truth),
                                    fmt::format("{:.6g}", seen), std::abs(seen - cut_off) < 1e-12 * truth});
                }
                for (const double threshold : {0.01, 0.0001}) {
                    const double lost = truth - room.brightness({.depth = 1000, .threshold = threshold});
                    const double bound = threshold / (1 - rho);
                    rows.push_back({fmt::format("threshold {:g}", threshold),
                                    fmt::format("holds: {:g} lost at most", bound), fmt::format("{:.3g} lost", lost),
                                    lost >= 0 && lost <= bound * (1 + 1e-9)});
                }
                rows.push_back(worth_row(0.01, run));
                return rows;
            }};
}

struct Sight {
    double seen = 0, rays = 0;
    double lost_at_most = 0;  // by rays that were not followed: no brightness exceeds 1
};

Sight through_panes(int count, const WhittedOptions& options) {
    const RayTree tree = panes(count).tree(options);
    Sight sight{.seen = tree.pixel.x};
    for (const auto& node : tree.nodes) {
        const bool followed = node.ended != Ending::depth && node.ended != Ending::threshold;
        sight.rays += followed;
        if (!followed) sight.lost_at_most += node.throughput;
    }
    return sight;
}

CaseRow panes_row(int count, const WhittedOptions& options, const std::string& how) {
    const double truth = panes_truth(count);
    const auto [seen, rays, lost_at_most] = through_panes(count, options);
    const std::string title = fmt::format("{} pane{}, {}", count, count == 1 ? "" : "s", how);
    const std::string sight = fmt::format("{:.9f} with {:.0f} rays", seen, rays);
    if (2 * count >= options.depth)
        return {title, fmt::format("fails: blind, sees 0 of {:.9f}", truth), sight, seen == 0};
    return {title, fmt::format("holds: {:.9f}, {:.3g} lost at most", truth, lost_at_most), sight,
            truth - seen >= -1e-12 && truth - seen <= lost_at_most + 1e-12};
}

StabilityCase panes_case() {
    return {"PANES",
            "Through m panes of glass comes T = (1 - r) / (1 + (2 m - 1) r) of the light, all bounces "
            "counted.",
            [] {
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
    double lost_at_most = 0;  // by rays below the threshold
};

Bombed bombed(double threshold) {
    const RayTree tree = glass_chamber(15).tree({.depth = 15, .threshold = threshold, .reflectance = by_fresnel});
    Bombed result{.seen = tree.pixel.x};
    for (const auto& node : tree.nodes) {
        result.rays += node.ended != Ending::depth && node.ended != Ending::threshold;
        if (node.ended == Ending::threshold)
            result.lost_at_most += node.throughput * glass_chamber_brightest(15 - node.depth);
    }
    return result;
}

StabilityCase ray_bomb() {
    return {"RAY-BOMB",
            "An eye inside the glass of a chamber of 15 glass surfaces: every hit makes two rays "
            "of one.",
            [] {
                const Bombed all = bombed(0);
                std::vector<CaseRow> rows{{"depth 15", "fails: explodes, 2^15 - 1 = 32767 rays",
                                           fmt::format("{:.0f} rays", all.rays), all.rays == 32767}};
                for (const auto& [threshold, budget] : {std::pair{0.01, 200.0}, std::pair{0.001, 1000.0}}) {
                    const Bombed some = bombed(threshold);
                    const double lost = std::abs(all.seen - some.seen);
                    rows.push_back({fmt::format("depth 15, threshold {:g}", threshold),
                                    fmt::format("holds: at most {:.0f} rays, {:.3g} of {:.3g} lost at most", budget,
                                                some.lost_at_most, all.seen),
                                    fmt::format("{:.0f} rays, {:.3g} lost", some.rays, lost),
                                    some.rays <= budget && lost <= some.lost_at_most});
                }
                return rows;
            }};
}

}  // namespace

std::vector<StabilityCase> room_cases(const ChapterRun& run) { return {hall(run), panes_case(), ray_bomb()}; }

}  // namespace raylab::recursion
