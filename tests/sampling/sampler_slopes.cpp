#include "catch.h"

#include "raylab/experiment/sampler_error/sampler_error.h"

using namespace raylab;

namespace {

const SquareIntegrand smooth = smooth_integrand(), disc = disc_integrand(), upright_step = step_integrand();

}  // namespace

TEST_CASE("the error of random samples falls as N^-1/2, whatever is integrated") {
    for (const SquareIntegrand& integrand : {smooth, disc, upright_step})
        CHECK_THAT(sampler_slope(SamplerKind::random, integrand), WithinAbs(-0.5, 0.08));
}

TEST_CASE("the error of jittered samples falls as N^-3/4 at an edge and as N^-1 where the integrand is smooth") {
    CHECK_THAT(sampler_slope(SamplerKind::jittered, disc), WithinAbs(-0.75, 0.08));
    CHECK_THAT(sampler_slope(SamplerKind::jittered, smooth), WithinAbs(-1, 0.08));
}

TEST_CASE("the error of scrambled Sobol points falls at least as N^-1.4 where the integrand is smooth") {
    CHECK(sampler_slope(SamplerKind::sobol, smooth) <= -1.4);
    CHECK_THAT(sampler_slope(SamplerKind::sobol, disc), WithinAbs(-0.75, 0.08));
}

TEST_CASE("n-rooks help where the integrand changes along one axis, and nowhere else") {
    CHECK_THAT(sampler_slope(SamplerKind::n_rooks, upright_step), WithinAbs(-0.94, 0.08));
    CHECK_THAT(sampler_slope(SamplerKind::n_rooks, disc), WithinAbs(-0.5, 0.08));
}

TEST_CASE("at a count that is no square, stratified samples err less than random ones as well") {
    for (const int count : {5, 17, 24, 47})
        for (const SamplerKind kind : {SamplerKind::jittered, SamplerKind::multi_jittered, SamplerKind::sobol,
                                       SamplerKind::halton, SamplerKind::blue_noise})
            CHECK(sampler_rmse(kind, count, smooth) < 0.7 * sampler_rmse(SamplerKind::random, count, smooth));
}
