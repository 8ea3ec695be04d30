#include "cases.h"

#include "raylab/base/error.h"
#include "raylab/base/number_text.h"
#include "raylab/sampling/mapping/lens_point.h"
#include "raylab/sampling/pattern/halton.h"
#include "raylab/sampling/random.h"
#include "raylab/sampling/sampler.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace raylab::spread {

namespace {

double random(std::uint64_t seed, std::uint64_t sample, std::uint64_t dimension) {
    return random_number({seed, 0, sample, dimension});
}

// A point of the lens of radius 1, as it is found where the root is forgotten: too many lie near the centre.
DiskPoint crowded_point(double u, double v) {
    const double turn = 2 * std::numbers::pi * v;
    return {u * std::cos(turn), u * std::sin(turn)};
}

using LensMap = std::function<DiskPoint(double, double)>;

const LensMap right_map = [](double u, double v) { return lens_point(1, u, v); };

// DISK-SQRT: how many points lie within half of the lens' radius, a quarter of its area.
double share_within_half(const LensMap& map) {
    constexpr int samples = 10'000;
    int within = 0;
    for (int i = 0; i < samples; ++i) {
        const auto [x, y] =
            map(random(1, static_cast<std::uint64_t>(i), 0), random(1, static_cast<std::uint64_t>(i), 1));
        within += x * x + y * y < 0.25;
    }
    return within / static_cast<double>(samples);
}

std::vector<CaseRow> disk_rows() {
    const double crowded = share_within_half(crowded_point), right = share_within_half(right_map);
    return {{"radius in proportion to u", "fails: twice as many as there should be within half of the radius",
             share_text(crowded) + " of the points", std::abs(crowded - 0.5) < 0.02},
            {"equal areas stay equal", "holds: 25 % within half of the radius", share_text(right) + " of the points",
             std::abs(right - 0.25) < 0.02}};
}

// SLOPE-AND-BIAS: the RMSE of the mean of x^2 over the lens, which is 1/4, at two numbers of samples.
std::array<double, 2> lens_errors(const LensMap& map, int few, int many) {
    constexpr int seeds = 100;
    std::array<double, 2> errors{};
    for (std::size_t which = 0; which < 2; ++which) {
        const int count = which == 0 ? few : many;
        double squares = 0;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            double sum = 0;
            for (int i = 0; i < count; ++i) {
                const auto [u, v] = pair({SamplerKind::random, count, seed}, {.index = i}, 0);
                const double x = map(u, v).x;
                sum += x * x;
            }
            squares += std::pow(sum / count - 0.25, 2);
        }
        errors[which] = std::sqrt(squares / seeds);
    }
    return errors;
}

double slope(const std::array<double, 2>& errors, int few, int many) {
    return std::log(errors[1] / errors[0]) / std::log(static_cast<double>(many) / few);
}

std::vector<CaseRow> bias_rows() {
    const auto row = [](const std::string& name, const LensMap& map, int few, int many, const std::string& expected,
                        const std::function<bool(double)>& is_expected) {
        const auto errors = lens_errors(map, few, many);
        const double fall = slope(errors, few, many);
        return CaseRow{fmt::format("{}, {} to {} samples", name, few, many), expected,
                       fmt::format("slope {:.2f}, RMSE {:.2g}", fall, errors[1]), is_expected(fall)};
    };
    const auto falls = [](double fall) { return fall < -0.35; };
    return {
        row("no root", crowded_point, 1, 4, "nothing: few samples hide a bias", [](double) { return true; }),
        row("no root", crowded_point, 1024, 16'384, "fails: the error stays", [](double fall) { return fall > -0.1; }),
        row("equal areas", right_map, 1024, 16'384, "holds: slope -1/2", falls)};
}

// SAME-NUMBER-TWICE: the pixel's edge lies across, and so does the lens: of a far edge, blurred over a pixel, a half is
// seen. If one number serves for both, the ray always leaves from that side of the lens.
double seen_through_lens(const std::function<std::array<double, 2>(int)>& numbers) {
    constexpr int samples = 65'536;
    int seen = 0;
    for (int i = 0; i < samples; ++i) {
        const auto [pixel, lens] = numbers(i);
        seen += (pixel - 0.5) + (lens - 0.5) > 0.25;  // where the ray meets the edge's plane
    }
    return seen / static_cast<double>(samples);
}

std::vector<CaseRow> twice_rows() {
    constexpr double truth = 0.28125;  // (3/4)^2 / 2: of the unit square, what lies above x + y = 5/4
    const double twice = seen_through_lens([](int i) {
        const double u = random(1, static_cast<std::uint64_t>(i), 0);
        return std::array{u, u};
    });
    const double apart = seen_through_lens([](int i) {
        const Sampler sampler{SamplerKind::sobol, 65'536, 1};
        return std::array{pair(sampler, {.index = i}, 0)[0], pair(sampler, {.index = i}, 1)[0]};
    });
    const auto words = [=](double seen) { return fmt::format("{} for {}", share_text(seen), share_text(truth)); };
    return {{"one number for pixel and lens", "fails: more than 8 % of the pixel wrong, however many samples",
             words(twice), std::abs(twice - truth) > 0.08},
            {"a number for each purpose", "holds: within 1 %", words(apart), std::abs(apart - truth) < 0.01}};
}

// PADDING: how many of the 8 x 8 cells of the square 64 points leave empty; random ones leave 37 %.
double empty_cells(const std::function<std::array<double, 2>(int)>& point) {
    std::array<bool, 64> has{};
    for (int i = 0; i < 64; ++i) {
        const auto [x, y] = point(i);
        has[static_cast<std::size_t>(8 * static_cast<int>(8 * y) + static_cast<int>(8 * x))] = true;
    }
    return static_cast<double>(std::ranges::count(has, false)) / 64;
}

std::vector<CaseRow> padding_rows() {
    const double halton = empty_cells([](int i) {
        const auto index = static_cast<std::uint32_t>(i);
        return std::array{radical_inverse(113, index), radical_inverse(127, index)};
    });
    const double padded = empty_cells([](int i) { return pair({SamplerKind::sobol, 64, 1}, {.index = i}, 15); });
    return {{"Halton's dimensions 30 and 31, bases 113 and 127", "fails: more cells empty than by chance (37 %)",
             share_text(halton) + " of 64 cells empty", halton > 0.5},
            {"two dimensions, used again with other scrambling (padding)", "holds: one in each cell",
             share_text(padded) + " of 64 cells empty", padded == 0}};
}

// STROBE: the share of an open shutter in which a pixel is covered, for pixels along the ramp that a moving edge
// leaves. If all pixels see the same moments, the ramp has steps; else it has noise, which the eye forgives.
std::vector<CaseRow> strobe_rows() {
    constexpr int pixels = 256, samples = 4;
    const auto distinct = [](const std::function<double(int pixel, int sample)>& time) {
        std::vector<double> levels;
        int jumps = 0;  // between neighbours, of a whole step
        double last = 0;
        for (int p = 0; p < pixels; ++p) {
            int covered = 0;
            for (int i = 0; i < samples; ++i) covered += time(p, i) < (p + 0.5) / pixels;
            const double level = covered / static_cast<double>(samples);
            if (p > 0 && level != last) ++jumps;
            last = level;
        }
        return jumps;
    };
    const int same = distinct([](int, int i) { return (i + 0.5) / samples; });
    const int own = distinct([](int p, int i) {
        return number({SamplerKind::jittered, samples, 1}, {.pixel = static_cast<std::uint64_t>(p), .index = i}, 2);
    });
    return {{"the same 4 moments in all pixels", "fails: 4 steps, as of 4 exposures",
             fmt::format("{} changes along {} pixels", same, pixels), same == samples},
            {"each pixel its own moments", "holds: more than 50 changes", fmt::format("{} changes", own), own > 50}};
}

// FOCUS-ON-EYE: where the plane in focus comes to the lens, every ray starts in its own target.
std::vector<CaseRow> focus_rows() {
    std::string observed = "accepted";
    try {
        read_scene_text("raylab = 1\n[camera]\nlens = { radius = 0.1, focus = 0 }\n", "focus.toml");
    } catch (const Error& error) {
        observed = error.what();
    }
    const auto direction = [](double focus, double at) {  // of the ray to the middle of the picture
        const Vec3d to = Vec3d{0, 0, -focus} - Vec3d{at, 0, 0};
        return to / glm::length(to);
    };
    const double turned = std::acos(std::min(1.0, -direction(1e-9, 0.1).z)) * 180 / std::numbers::pi;
    return {{"unchecked: a focus of a nanometre, a lens of 10 cm", "fails: rays leave along the lens",
             fmt::format("{:.4g} degrees from the way of sight", turned), turned > 89},
            {"the lab, a focus of 0", "holds: refused, with the line", observed,
             observed.find("focus.toml:3: expected a number above 0 for focus") != std::string::npos}};
}

}  // namespace

std::vector<StabilityCase> sampling_cases(const ChapterRun&) {
    return {
        {"DISK-SQRT", "Points of a round lens from two numbers: the radius takes a root.", disk_rows},
        {"SLOPE-AND-BIAS",
         "The mean of a square over the lens, by a map that is wrong: an error that falls proves little.", bias_rows},
        {"SAME-NUMBER-TWICE", "One random number decides where in the pixel, and where on the lens.", twice_rows},
        {"PADDING", "The thirtieth and the next dimension of a sequence that is even in its first two.", padding_rows},
        {"STROBE", "A moving edge, four moments a pixel.", strobe_rows},
        {"FOCUS-ON-EYE", "The plane in focus lies in the lens.", focus_rows}};
}

}  // namespace raylab::spread
