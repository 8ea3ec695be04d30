#include "cases.h"

#include "raylab/base/number_text.h"
#include "raylab/image/sampled_image.h"
#include "raylab/sampling/random.h"
#include "raylab/transport/path/expected_error.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>

namespace raylab::spread {

namespace {

constexpr double z = 1.96;  // 95 of 100 normal deviates are smaller

// Coins that fall on 1 with chance p: a pixel of which this share is lit.
class Coin {
public:
    Coin(double p, std::uint64_t seed) : p_(p), seed_(seed) {}
    double next() { return random_number({seed_, 0, count_++, 0}) < p_ ? 1 : 0; }

private:
    double p_;
    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

struct Interval {
    double mean, half_width;
    bool has(double truth) const { return std::abs(mean - truth) <= half_width; }
};

// Samples until the interval, taken for what it says after each sample, is narrow enough.
Interval naively_stopped(double p, double half_width, std::uint64_t seed) {
    constexpr int fewest = 8, most = 100'000;
    Coin coin(p, seed);
    double sum = 0;
    for (int n = 1; n <= most; ++n) {
        sum += coin.next();
        const double mean = sum / n;
        const double found = z * std::sqrt(mean * (1 - mean) / n);
        if (n >= fewest && found <= half_width) return {mean, found};
    }
    return {sum / most, half_width};
}

double share_covered(const std::function<Interval(std::uint64_t seed)>& interval, double truth, int trials) {
    int covered = 0;
    for (int i = 0; i < trials; ++i) covered += interval(static_cast<std::uint64_t>(i)).has(truth);
    return static_cast<double>(covered) / trials;
}

// ADAPTIVE-BIAS: how many of the intervals of 95 % that end the sampling contain the truth.
std::vector<CaseRow> bias_rows(const ChapterRun& run) {
    const int trials = run.sized(2000, 500);
    std::vector<CaseRow> rows;
    for (const double p : {0.5, 0.1, 0.02}) {
        const double half_width = p / 5;
        const double naive =
            share_covered([&](std::uint64_t seed) { return naively_stopped(p, half_width, seed); }, p, trials);
        const bool fails = p < 0.2;
        rows.push_back({fmt::format("stops when its own estimate is good enough, p = {}", p),
                        fails ? "fails: fewer than 90 % contain the truth" : "holds: more than 90 % contain the truth",
                        share_text(naive) + " contain the truth", fails == (naive < 0.9)});
        // As many samples as theory asks for, decided before the first is seen.
        const int count = static_cast<int>(std::ceil(z * z * p * (1 - p) / (half_width * half_width)));
        const double fixed = share_covered(
            [&](std::uint64_t seed) {
                Coin coin(p, seed);
                double sum = 0;
                for (int n = 0; n < count; ++n) sum += coin.next();
                return Interval{sum / count, half_width};
            },
            p, trials);
        rows.push_back({fmt::format("{} samples, whatever they say, p = {}", count, p),
                        "holds: more than 90 % contain the truth", share_text(fixed) + " contain the truth",
                        fixed > 0.9});
    }
    return rows;
}

// THIN-PENUMBRA: pixels that a thin penumbra covers by a twentieth. The first four samples agree in most of them.
std::vector<CaseRow> penumbra_rows(const ChapterRun& run) {
    const int pixels = run.sized(2000, 500);
    constexpr double lit = 0.05;
    int stopped_early = 0;
    double sum_adaptive = 0;
    for (int i = 0; i < pixels; ++i) {
        Coin coin(lit, static_cast<std::uint64_t>(i) + 10'000);
        double sum = 0;
        int n = 0;
        while (n < 4) sum += coin.next(), ++n;
        if (sum == 0 || sum == 4) {
            ++stopped_early;
        } else {
            while (n < 256) sum += coin.next(), ++n;
        }
        sum_adaptive += sum / n;
    }
    const double early = static_cast<double>(stopped_early) / pixels, mean = sum_adaptive / pixels;
    return {{"stops where four samples agree", "fails: more than half of the pixels stop, a tenth of the light is lost",
             fmt::format("{} stop, mean {:.3f} for {}", share_text(early), mean, lit),
             early > 0.5 && mean < 0.9 * lit}};
}

}  // namespace

std::vector<StabilityCase> stopping_cases(const ChapterRun& run) {
    return {{"ADAPTIVE-BIAS", "Coins are thrown until the interval that they give themselves is narrow enough.",
             [run] { return bias_rows(run); }},
            {"THIN-PENUMBRA", "A twentieth of a pixel is lit, and four samples decide whether it gets more.",
             [run] { return penumbra_rows(run); }}};
}

}  // namespace raylab::spread
