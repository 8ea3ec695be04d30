#include "raylab/accelerator/split_tree/finite_cell.h"
#include "raylab/accelerator/split_tree/plane_rule.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace raylab {

namespace {

// More parts than this are counted in bins instead of sorted, because the first few splits need not be that exact.
constexpr std::size_t most_sorted = 4096;
constexpr std::size_t bin_count = 128;

struct Best {
    double cost;
    std::optional<SplitPlane> plane = {};
};

// One axis of a cell, and the best plane across it so far.
class Candidates {
public:
    Candidates(const SahCosts& costs, const CutCost& cost, const Box& cell, std::size_t axis, Best& best)
        : cost_(&cost),
          axis_(axis),
          low_(cell.min[static_cast<int>(axis)]),
          high_(cell.max[static_cast<int>(axis)]),
          best_(&best),
          cut_{size(cell), static_cast<int>(axis), 0, 0, 0, costs.visit, costs.test, costs.empty_bonus} {}

    float low() const { return low_; }
    float high() const { return high_; }

    void consider(float at, std::size_t below, std::size_t in_plane, std::size_t above) {
        if (!(at > low_ && at < high_)) return;
        consider(at, below + in_plane, above, SplitPlane::InPlane::below);
        if (in_plane > 0) consider(at, below, above + in_plane, SplitPlane::InPlane::above);
    }

private:
    void consider(float at, std::size_t below, std::size_t above, SplitPlane::InPlane side) {
        cut_.place = double{at} - low_;
        cut_.below = static_cast<double>(below);
        cut_.above = static_cast<double>(above);
        const double cost = (*cost_)(cut_);
        if (cost < best_->cost) *best_ = {cost, SplitPlane{axis_, at, side}};
    }

    const CutCost* cost_;
    std::size_t axis_;
    float low_, high_;
    Best* best_;
    SahCut cut_;
};

// The place where a part begins or ends, as an integer that sorts: in the order of the floats, and at equal places the
// ends before the beginnings.
enum class Kind : std::uint64_t { end, in_plane, begin };

std::uint64_t event(float at, Kind kind) {
    const auto bits = std::bit_cast<std::uint32_t>(at == 0 ? 0.0f : at);
    const std::uint64_t ordered = bits & 0x8000'0000u ? ~bits : bits | 0x8000'0000u;
    return ordered << 2 | static_cast<std::uint64_t>(kind);
}

float place_of(std::uint64_t event) {
    const auto ordered = static_cast<std::uint32_t>(event >> 2);
    return std::bit_cast<float>(ordered & 0x8000'0000u ? ordered & 0x7fff'ffffu : ~ordered);
}

// Tries every place where a part begins or ends: the lowest cost is at one of them.
void sweep(std::span<const CellPart> parts, int axis, Candidates& candidates) {
    std::vector<std::uint64_t> events;
    events.reserve(2 * parts.size());
    for (const CellPart& part : parts) {
        const float low = part.box.min[axis], high = part.box.max[axis];
        if (low == high) {
            events.push_back(event(low, Kind::in_plane));
        } else {
            events.push_back(event(low, Kind::begin));
            events.push_back(event(high, Kind::end));
        }
    }
    std::ranges::sort(events);
    std::size_t below = 0, above = parts.size();
    for (std::size_t i = 0; i < events.size();) {
        std::array<std::size_t, 3> here{};  // how many events of each kind are here
        const std::uint64_t first = events[i];
        for (; i < events.size() && events[i] >> 2 == first >> 2; ++i) ++here[events[i] & 3];
        above -= here[0] + here[1];
        candidates.consider(place_of(first), below, here[1], above);
        below += here[1] + here[2];
    }
}

// Tries equally spaced planes; the parts are counted by the bins in which they begin and end.
void count(std::span<const CellPart> parts, int axis, Candidates& candidates) {
    const double low = candidates.low(), width = (candidates.high() - low) / bin_count;
    if (!(width > 0)) return;
    std::array<std::size_t, bin_count> begin{}, end{};
    const auto bin = [&](float x) {
        return static_cast<std::size_t>(std::clamp((x - low) / width, 0.0, bin_count - 1.0));
    };
    for (const CellPart& part : parts) {
        ++begin[bin(part.box.min[axis])];
        ++end[bin(part.box.max[axis])];
    }
    std::size_t below = 0, above = parts.size();
    for (std::size_t i = 1; i < bin_count; ++i) {
        below += begin[i - 1];
        above -= end[i - 1];
        candidates.consider(cast<float>(low + static_cast<double>(i) * width), below, 0, above);
    }
}

}  // namespace

PlaneRule surface_area_heuristic(const SahCosts& costs) { return surface_area_heuristic(costs, sah_cost); }

PlaneRule surface_area_heuristic(const SahCosts& costs, const CutCost& cost) {
    return [costs, cost](const Box& whole, std::span<const CellPart> parts) {
        const Box cell = finite(whole);
        Best best{costs.test * static_cast<double>(parts.size())};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Candidates candidates(costs, cost, cell, axis, best);
            const auto i = static_cast<int>(axis);
            if (parts.size() > most_sorted) {
                count(parts, i, candidates);
            } else {
                sweep(parts, i, candidates);
            }
        }
        return best.plane;
    };
}

}  // namespace raylab
