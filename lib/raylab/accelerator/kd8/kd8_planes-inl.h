// Compiled once for every instruction set (see kd8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_KD8_PLANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_KD8_PLANES_INL_H
#undef RAYLAB_KD8_PLANES_INL_H
#else
#define RAYLAB_KD8_PLANES_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_box_ray-inl.h"
#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"
#include "raylab/accelerator/kd8/kd8_node.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// The ranges of t in which a ray is in each of eight cells.
struct Kd8Ranges {
    alignas(32) std::array<float, bvh8_width> entries, exits;
};

// A ray's numbers, to find where it is in each of a node's cells.
//
// A cell is a box, and the range of t in it is what BoxRay says, which never misses one that the ray exactly hits: the
// latest entry and the first exit by all of its planes, those of the cells around it among them. Of a plane's two t the
// nearer is the entry to the cells behind it, and the farther the exit from those before it. (No t of a range is
// negative: 0 is an entry that limits nothing.)
#if HWY_TARGET == HWY_SCALAR

class PlaneLanes {
public:
    explicit PlaneLanes(const BoxRay& ray) : ray_(ray) {}

    // A mask of the node's cells in which the ray is between two t, and in which something lies.
    std::uint32_t hit_mask(const Kd8Node& node, float entry, float exit, Kd8Ranges& ranges) const {
        std::uint32_t hit_found = 0;
        for (std::size_t cell = 0; cell < bvh8_width; ++cell) {
            float &from = ranges.entries[cell] = entry, &to = ranges.exits[cell] = exit;
            for (int level = 0; level < 3; ++level) {
                const std::size_t place = Kd8Node::plane_between(cell, level), axis = node.children[place].axis();
                const float plane = node.planes[place], inverse = ray_.inverse[axis];
                if (Kd8Node::is_above(cell, level) == (inverse > 0))
                    from = std::max(from, (plane - ray_.near_start[axis]) * inverse);
                else
                    to = std::min(to, (plane - ray_.far_start[axis]) * inverse);
            }
            const bool is_open = std::bit_cast<std::int32_t>(from) <= std::bit_cast<std::int32_t>(to) + BoxRay::slack;
            if (is_open && !node.children[cell].is_none()) hit_found |= 1u << cell;
        }
        return hit_found;
    }

private:
    const BoxRay& ray_;
};

#else

class PlaneLanes {
public:
    HWY_INLINE explicit PlaneLanes(const BoxRay& ray)
        : near_start_(hn::LoadDup128(lanes_tag, ray.near_start)),
          far_start_(hn::LoadDup128(lanes_tag, ray.far_start)),
          inverse_(hn::LoadDup128(lanes_tag, ray.inverse)) {}

    // A mask of the node's cells in which the ray is between two t, and in which something lies.
    HWY_INLINE std::uint32_t hit_mask(const Kd8Node& node, float entry, float exit, Kd8Ranges& ranges) const {
        std::uint32_t hit_found = 0;
        for (std::size_t i = 0; i < bvh8_width; i += lanes) {
            const Integers words = hn::Load(integers, reinterpret_cast<const std::int32_t*>(node.children.data()) + i);
            const Floats plane = hn::Load(lanes_tag, node.planes.data() + i), inverse = along_axes(inverse_, words);
            const Floats nearer = BoxRay::t_at(plane, along_axes(near_start_, words), inverse),
                         farther = BoxRay::t_at(plane, along_axes(far_start_, words), inverse);
            const Mask is_backward = mask(hn::Lt(hn::BitCast(integers, inverse), hn::Zero(integers)));
            const Floats never = all(std::numeric_limits<float>::infinity());
            const Limits entries{hn::IfThenElseZero(is_backward, nearer), hn::IfThenZeroElse(is_backward, nearer)},
                exits{hn::IfThenElse(is_backward, never, farther), hn::IfThenElse(is_backward, farther, never)};
            const Floats from =
                hn::Max(hn::Max(entries.of_all(i), entries.of_halves()), hn::Max(entries.of_neighbours(), all(entry)));
            const Floats to =
                hn::Min(hn::Min(exits.of_all(i), exits.of_halves()), hn::Min(exits.of_neighbours(), all(exit)));
            hn::Store(from, lanes_tag, ranges.entries.data() + i);
            hn::Store(to, lanes_tag, ranges.exits.data() + i);
            // (Compared as integers, as in BoxLanes.)
            const Integers too_late = hn::Add(hn::BitCast(integers, to), hn::Set(integers, BoxRay::slack + 1));
            const auto is_none = hn::Eq(hn::Or(words, hn::Set(integers, 3)), hn::Set(integers, -1));
            hit_found |= bits(mask(hn::AndNot(is_none, hn::Lt(hn::BitCast(integers, from), too_late)))) << i;
        }
        return hit_found;
    }

private:
    using IntegerLanes = hn::RebindToSigned<Lanes>;
    using Integers = hn::Vec<IntegerLanes>;
    static constexpr IntegerLanes integers{};
    static HWY_INLINE Mask mask(hn::Mask<IntegerLanes> of) { return hn::RebindMask(lanes_tag, of); }

    // What limits the cells below each plane, and those above it: for each cell by its plane at every level. (Planes
    // and cells lie in blocks of four, in which they are permuted: from block to block takes three times as long.)
    struct Limits {
        Floats below, above;
        HWY_INLINE Floats of_all(std::size_t first) const {
            if constexpr (lanes == 4) return hn::Broadcast<0>(first == 0 ? below : above);
            const Mask is_below = mask(hn::Lt(hn::Iota(integers, 0), hn::Set(integers, 4)));
            return hn::Broadcast<0>(hn::IfThenElse(is_below, below, above));
        }
        HWY_INLINE Floats of_halves() const {
            const Floats both = hn::InterleaveLower(lanes_tag, below, above);
            return hn::InterleaveUpper(lanes_tag, both, both);
        }
        HWY_INLINE Floats of_neighbours() const { return hn::InterleaveUpper(lanes_tag, below, above); }
    };

    // Of three numbers, the one of each plane's axis.
    static HWY_INLINE Floats along_axes(Floats numbers, Integers words) {
#if HWY_TARGET <= HWY_AVX2
        return Floats{_mm256_permutevar_ps(numbers.raw, words.raw)};  // reads the lowest two bits
#else
        const Integers axes = hn::And(words, hn::Set(integers, 3));
        const auto is = [&](std::int32_t axis) HWY_ATTR { return mask(hn::Eq(axes, hn::Set(integers, axis))); };
        return hn::IfThenElse(is(0), hn::Broadcast<0>(numbers),
                              hn::IfThenElse(is(1), hn::Broadcast<1>(numbers), hn::Broadcast<2>(numbers)));
#endif
    }

    Floats near_start_, far_start_, inverse_;  // along x, y, z, in each block
};

#endif

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
