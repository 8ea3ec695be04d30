#include "catch.h"

#include "raylab/sampling/sampler.h"

#include <cmath>
#include <functional>
#include <numbers>

// How fast the error falls with the number of samples N: the slope of the line through log RMSE over log N, for N = 16,
// 64, ..., 4096. An RMSE of 200 seeds is known to 5 %, and such a slope to 0.01. Expected: random -1/2; jittered -3/4
// at an edge (Mitchell, SIGGRAPH 1996) and -1 where smooth; scrambled nets -3/2 where smooth (Owen, 1997).

using namespace raylab;

namespace {

struct Integrand {
    std::function<double(double, double)> value;
    double truth;
};

const Integrand smooth{[](double x, double y) { return std::exp(x + y); }, std::pow(std::numbers::e - 1, 2)};
const Integrand disc{[](double x, double y) { return x * x + y * y < 1 ? 1.0 : 0.0; }, std::numbers::pi / 4};
const Integrand upright_step{[](double x, double) { return x < 0.37 ? 1.0 : 0.0; }, 0.37};

double rmse(SamplerKind kind, int count, const Integrand& integrand) {
    constexpr std::uint64_t seeds = 200;
    double squares = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            const auto [x, y] = pair({.kind = kind, .count = count, .seed = seed}, {.pixel = 3, .index = i}, 5);
            sum += integrand.value(x, y);
        }
        squares += std::pow(sum / count - integrand.truth, 2);
    }
    return std::sqrt(squares / seeds);
}

double slope(SamplerKind kind, const Integrand& integrand) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int count = 16; count <= 4096; count *= 4) {
        const double at = std::log(count), error = std::log(rmse(kind, count, integrand));
        n += 1;
        x += at;
        y += error;
        xx += at * at;
        xy += at * error;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

TEST_CASE("the error of random samples falls as N^-1/2, whatever is integrated") {
    for (const Integrand& integrand : {smooth, disc, upright_step})
        CHECK_THAT(slope(SamplerKind::random, integrand), WithinAbs(-0.5, 0.08));
}

TEST_CASE("the error of jittered samples falls as N^-3/4 at an edge and as N^-1 where the integrand is smooth") {
    CHECK_THAT(slope(SamplerKind::jittered, disc), WithinAbs(-0.75, 0.08));
    CHECK_THAT(slope(SamplerKind::jittered, smooth), WithinAbs(-1, 0.08));
}

TEST_CASE("the error of scrambled Sobol points falls at least as N^-1.4 where the integrand is smooth") {
    CHECK(slope(SamplerKind::sobol, smooth) <= -1.4);
    CHECK_THAT(slope(SamplerKind::sobol, disc), WithinAbs(-0.75, 0.08));
}

TEST_CASE("n-rooks help where the integrand changes along one axis, and nowhere else") {
    CHECK_THAT(slope(SamplerKind::n_rooks, upright_step), WithinAbs(-0.94, 0.08));
    CHECK_THAT(slope(SamplerKind::n_rooks, disc), WithinAbs(-0.5, 0.08));
}

TEST_CASE("at a count that is no square, stratified samples err less than random ones as well") {
    for (const int count : {5, 17, 24, 47})
        for (const SamplerKind kind : {SamplerKind::jittered, SamplerKind::multi_jittered, SamplerKind::sobol,
                                       SamplerKind::halton, SamplerKind::blue_noise})
            CHECK(rmse(kind, count, smooth) < 0.7 * rmse(SamplerKind::random, count, smooth));
}
