#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Samplers: where in [0, 1)^2 the samples of a pixel lie. All give uniform numbers; they differ in how evenly the
// samples of one pixel fill the square. Nothing is drawn from a stream: the numbers are a function of their place.

namespace raylab {

enum class SamplerKind {
    random,          // independent
    jittered,        // one in each of `count` cells of equal area (Cook, Porter and Carpenter, SIGGRAPH 1984)
    multi_jittered,  // that, and evenly spread over x and over y (Kensler: Correlated Multi-Jittered Sampling, 2013)
    n_rooks,         // one in each row and one in each column of a count x count grid (Shirley, Eurographics 1991)
    halton,          // radical inverses to bases 2 and 3, scrambled
    sobol,           // Sobol's first two dimensions, scrambled as Owen described (1995); see Sampler::beside_first
    blue_noise,      // Sobol's points, the same for all pixels, shifted by a mask: neighbours err differently
};

/// A way to sample pixels. A pair costs 10 ns (random) to 80 ns (halton); `sobol` 26 ns.
struct Sampler {
    SamplerKind kind = SamplerKind::sobol;
    int count = 16;  // samples of a pixel; at least 1
    std::uint64_t seed = 1;
    /// The purpose whose pairs `sobol` spreads evenly together with those of purpose 0: the third and the fourth
    /// dimension of one sequence (Burley, "Practical Hash-Based Owen Scrambling", JCGT 9(4), 2020). An edge that is
    /// blurred by both a pixel and a lens is one edge in four dimensions, and pairs that meet in any order miss it.
    int beside_first = none;

    static constexpr int none = -1;
};

/// Which sample of which pixel.
struct SamplePlace {
    std::uint64_t pixel = 0;  // no two pixels share a number
    int x = 0, y = 0;         // where the pixel is, for the mask of blue_noise
    int index = 0;            // 0 to count - 1
};

/// The point in [0, 1)^2 of a sample for a purpose. A purpose is any number that the caller gives to one use (the
/// pixel's filter, the lens, the light at the third vertex of a path): the points of different purposes are independent
/// of one another, but for Sampler::beside_first, and so are pair() and number() of the same purpose.
std::array<double, 2> pair(const Sampler& sampler, const SamplePlace& place, int purpose);

/// The number in [0, 1) of a sample for a purpose: in one dimension all samplers but `random` and `blue_noise` have one
/// in each of `count` intervals, or of the powers of the base.
double number(const Sampler& sampler, const SamplePlace& place, int purpose);

/// The name in options and files: "multi_jittered".
std::string to_string(SamplerKind kind);

/// All names, in the order of SamplerKind.
std::vector<std::string> sampler_names();

/// The sampler of this name. An Error names the nearest.
SamplerKind sampler_kind(std::string_view name);

}  // namespace raylab
