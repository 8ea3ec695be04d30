#include "raylab/sampling/sampler.h"

#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"
#include "raylab/sampling/pattern/blue_noise_mask.h"
#include "raylab/sampling/pattern/halton.h"
#include "raylab/sampling/pattern/jittered.h"
#include "raylab/sampling/pattern/owen_scrambled.h"
#include "raylab/sampling/pattern/sobol.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace raylab {

namespace {

constexpr std::array names{"random", "jittered", "multi_jittered", "n_rooks", "halton", "sobol", "blue_noise"};

// What all samples of a pixel share for one purpose: it chooses the pattern.
struct PatternKey {
    std::uint64_t bits;

    std::uint64_t inside(int index) const { return mixed(bits ^ static_cast<std::uint64_t>(index)); }
};

enum class Wanted : std::uint64_t { number, pair };  // which have different patterns for the same purpose

PatternKey pattern_key(const Sampler& sampler, std::uint64_t pixel, int purpose, Wanted wanted) {
    return {random_bits({.seed = sampler.seed,
                         .pixel = pixel,
                         .sample = static_cast<std::uint64_t>(purpose),
                         .dimension = static_cast<std::uint64_t>(wanted)})};
}

// Owen's scrambling of the indices themselves: blocks of 2^k stay together, and so remain evenly spread, but different
// purposes meet in another order.
std::uint32_t shuffled(int index, std::uint32_t key) {
    return reversed_bits(owen_scrambled(reversed_bits(static_cast<std::uint32_t>(index)), key));
}

double sobol_number(int index, PatternKey key) {
    const std::uint32_t at = shuffled(index, low_half(key.bits));
    return fraction(reversed_bits(owen_scrambled(reversed_sobol_x(at), high_half(key.bits))));
}

// Each coordinate is scrambled for itself.
std::array<double, 2> scrambled_pair(std::uint32_t reversed_x, std::uint32_t reversed_y, PatternKey key) {
    const std::uint32_t other = low_half(mixed(key.bits));
    return {fraction(reversed_bits(owen_scrambled(reversed_x, high_half(key.bits)))),
            fraction(reversed_bits(owen_scrambled(reversed_y, other)))};
}

std::array<double, 2> sobol_pair(int index, PatternKey key) {
    const std::uint32_t at = shuffled(index, low_half(key.bits));
    return scrambled_pair(reversed_sobol_x(at), reversed_sobol_y(at), key);
}

// Beside sobol_pair() of the purpose whose key is `first`: at the same place of the sequence.
[[gnu::noinline]] std::array<double, 2> sobol_pair_beside(PatternKey first, int index, PatternKey key) {
    const std::uint32_t at = shuffled(index, low_half(first.bits));
    return scrambled_pair(third_sobol.reversed(at), fourth_sobol.reversed(at), key);
}

// The pixel's number in a mask that lies elsewhere for each key.
double mask_number(const SamplePlace& place, std::uint64_t key, std::uint32_t inside) {
    const auto x = static_cast<std::uint32_t>(place.x) + low_half(key);
    const auto y = static_cast<std::uint32_t>(place.y) + high_half(key);
    return in_cell(BlueNoiseMask::instance().rank(x, y), fraction(inside), BlueNoiseMask::pixels);
}

double wrapped(double sum) { return sum < 1 ? sum : sum - 1; }

}  // namespace

std::array<double, 2> pair(const Sampler& sampler, const SamplePlace& place, int purpose) {
    const PatternKey key = pattern_key(sampler, place.pixel, purpose, Wanted::pair);
    const auto index = static_cast<std::uint32_t>(place.index), count = static_cast<std::uint32_t>(sampler.count);
    switch (sampler.kind) {
        case SamplerKind::random: {
            const std::uint64_t bits = key.inside(place.index);
            return {fraction(low_half(bits)), fraction(high_half(bits))};
        }
        case SamplerKind::jittered:
            return jittered_pair(index, count, key.bits, key.inside(place.index));
        case SamplerKind::multi_jittered:
            return multi_jittered_pair(index, count, key.bits, key.inside(place.index));
        case SamplerKind::n_rooks:
            return n_rooks_pair(index, count, key.bits, key.inside(place.index));
        case SamplerKind::halton: {
            const std::uint32_t at = permuted_index(index, count, key.bits);
            return {scrambled_radical_inverse<2>(at, count, mixed(key.bits)),
                    scrambled_radical_inverse<3>(at, count, mixed(~key.bits))};
        }
        case SamplerKind::sobol:
            if (purpose == sampler.beside_first)
                return sobol_pair_beside(pattern_key(sampler, place.pixel, 0, Wanted::pair), place.index, key);
            return sobol_pair(place.index, key);
        case SamplerKind::blue_noise:
            break;
    }
    const PatternKey shared = pattern_key(sampler, 0, purpose, Wanted::pair);
    const auto [x, y] = sobol_pair(place.index, shared);
    return {wrapped(x + mask_number(place, mixed(shared.bits ^ 1), low_half(key.bits))),
            wrapped(y + mask_number(place, mixed(shared.bits ^ 2), high_half(key.bits)))};
}

double number(const Sampler& sampler, const SamplePlace& place, int purpose) {
    const PatternKey key = pattern_key(sampler, place.pixel, purpose, Wanted::number);
    const auto index = static_cast<std::uint32_t>(place.index), count = static_cast<std::uint32_t>(sampler.count);
    switch (sampler.kind) {
        case SamplerKind::random:
            return fraction(low_half(key.inside(place.index)));
        case SamplerKind::jittered:
        case SamplerKind::multi_jittered:
        case SamplerKind::n_rooks:
            return jittered_number(index, count, key.bits, low_half(key.inside(place.index)));
        case SamplerKind::halton:
            return scrambled_radical_inverse<2>(permuted_index(index, count, key.bits), count, mixed(key.bits));
        case SamplerKind::sobol:
            return sobol_number(place.index, key);
        case SamplerKind::blue_noise:
            break;
    }
    const PatternKey shared = pattern_key(sampler, 0, purpose, Wanted::number);
    return wrapped(sobol_number(place.index, shared) + mask_number(place, mixed(shared.bits ^ 1), low_half(key.bits)));
}

std::string to_string(SamplerKind kind) { return names[static_cast<std::size_t>(kind)]; }

std::vector<std::string> sampler_names() { return {names.begin(), names.end()}; }

SamplerKind sampler_kind(std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw Error(fmt::format("expected a sampler ({}), found {}", fmt::join(names, ", "),
                                with_suggestion(name, sampler_names())));
    return static_cast<SamplerKind>(found - names.begin());
}

}  // namespace raylab
