#include "raylab/sampling/pattern/blue_noise_mask.h"

#include "raylab/sampling/random.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr std::uint32_t side = BlueNoiseMask::side, pixels = BlueNoiseMask::pixels;

// Points on the torus of pixels, and how crowded each pixel is by them: the sum of a Gaussian of the distances. In
// whole numbers, so that the order in which points come and go leaves no rounding errors behind.
class Crowd {
public:
    Crowd() : weights_(pixels), crowding_(pixels), taken_(pixels) {
        constexpr double width = 1.9;  // pixels; Ulichney has 1.5, and less regular patterns
        const auto apart = [](std::uint32_t a) { return std::min(a, side - a); };
        for (std::uint32_t i = 0; i < pixels; ++i) {
            const double x = apart(i % side), y = apart(i / side);
            weights_[i] = std::llround(0x1p30 * std::exp(-(x * x + y * y) / (2 * width * width)));
        }
    }

    void add(std::uint32_t place) { change(place, 1); }
    void remove(std::uint32_t place) { change(place, -1); }
    bool has(std::uint32_t place) const { return taken_[place] != 0; }

    std::uint32_t tightest_cluster() const { return extreme(1); }  // the point that is most crowded
    std::uint32_t largest_void() const { return extreme(0); }      // the free pixel that is least crowded

private:
    void change(std::uint32_t place, std::int64_t sign) {
        taken_[place] = sign > 0;
        const std::uint32_t x = place % side, y = place / side;
        for (std::uint32_t v = 0; v < side; ++v)
            for (std::uint32_t u = 0; u < side; ++u)
                crowding_[v * side + u] += sign * weights_[(v + side - y) % side * side + (u + side - x) % side];
    }

    std::uint32_t extreme(int taken) const {
        std::uint32_t best = pixels;
        const std::int64_t sign = taken ? 1 : -1;
        for (std::uint32_t i = 0; i < pixels; ++i)
            if (taken_[i] == taken && (best == pixels || sign * crowding_[i] > sign * crowding_[best])) best = i;
        return best;
    }

    std::vector<std::int64_t> weights_, crowding_;
    std::vector<char> taken_;
};

// Random points, moved from the tightest cluster into the largest void until that is where they came from.
Crowd even_crowd(std::uint32_t points) {
    Crowd crowd;
    for (std::uint64_t i = 0; points > 0; ++i) {
        const auto place = static_cast<std::uint32_t>(mixed(i) % pixels);
        if (crowd.has(place)) continue;
        crowd.add(place);
        --points;
    }
    for (;;) {
        const std::uint32_t from = crowd.tightest_cluster();
        crowd.remove(from);
        const std::uint32_t to = crowd.largest_void();
        crowd.add(to);
        if (to == from) return crowd;
    }
}

}  // namespace

// The first tenth gets its ranks as it is taken away, all others as they fill the voids.
BlueNoiseMask::BlueNoiseMask() {
    constexpr std::uint32_t first = pixels / 10;
    Crowd crowd = even_crowd(first);
    Crowd fewer = crowd;
    for (std::uint32_t rank = first; rank-- > 0;) {
        const std::uint32_t place = fewer.tightest_cluster();
        fewer.remove(place);
        ranks_[place] = static_cast<std::uint16_t>(rank);
    }
    for (std::uint32_t rank = first; rank < pixels; ++rank) {
        const std::uint32_t place = crowd.largest_void();
        crowd.add(place);
        ranks_[place] = static_cast<std::uint16_t>(rank);
    }
}

const BlueNoiseMask& BlueNoiseMask::instance() {
    static const BlueNoiseMask mask;
    return mask;
}

}  // namespace raylab
