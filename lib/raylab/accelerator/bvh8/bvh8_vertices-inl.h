// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_VERTICES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_VERTICES_INL_H
#undef RAYLAB_BVH8_VERTICES_INL_H
#else
#define RAYLAB_BVH8_VERTICES_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_vertices.h"
#include "raylab/number/four_floats.h"

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

constexpr auto places_tag = integers_tag;
using Places = Integers;

// One number of each of a leaf's vertices, from which corners look up theirs: in registers,
struct TableInRegisters {
    Floats first, second, third;

    HWY_INLINE void set(std::size_t lane, Floats values) {
        (lane < bvh8_width ? first : lane < 2 * bvh8_width ? second : third) = values;
    }
    HWY_INLINE Floats at(Places places, bool has_third) const {
        Floats found = of_two(places);
        if (has_third) [[unlikely]] {
            const Places lane = hn::And(places, hn::Set(places_tag, int{Bvh8Vertices::lane_mask}));
            found = hn::IfThenElse(is_beyond(lane, 15), in_one(third, lane), found);
        }
        return found;
    }

private:
    static HWY_INLINE Mask is_beyond(Places places, int lane) {
        return hn::RebindMask(lanes_tag, hn::Gt(places, hn::Set(places_tag, lane)));
    }
    static HWY_INLINE Floats in_one(Floats of, Places places) {
        const Places within = hn::And(places, hn::Set(places_tag, 7));
        return hn::TableLookupLanes(of, hn::IndicesFromVec(lanes_tag, within));
    }
    HWY_INLINE Floats of_two(Places places) const {
#if HWY_TARGET <= HWY_AVX3  // (Highway has this function only since version 1.0.4.)
        return Floats{_mm256_permutex2var_ps(first.raw, places.raw, second.raw)};
#elif HWY_TARGET == HWY_AVX2  // Its lookup asks three bits, its choice the sign, where the fourth is put.
        const __m256 chosen = _mm256_castsi256_ps(hn::ShiftLeft<28>(places).raw);
        const __m256 of_first = _mm256_permutevar8x32_ps(first.raw, places.raw),
                     of_second = _mm256_permutevar8x32_ps(second.raw, places.raw);
        __m256 found;  // (GCC would compare the signs with zero first, for the function of the same name.)
        asm("vblendvps %3, %2, %1, %0" : "=x"(found) : "x"(of_first), "x"(of_second), "x"(chosen));
        return Floats{found};
#else
        const Places lane = hn::And(places, hn::Set(places_tag, 15));
        return hn::IfThenElse(is_beyond(lane, 7), in_one(second, lane), in_one(first, lane));
#endif
    }
};

// ... or in memory, where the instruction set has fewer than eight lanes.
struct TableInMemory {
    std::array<float, Bvh8Vertices::largest> values;

    HWY_INLINE void set(std::size_t lane, Floats some) { hn::StoreU(some, lanes_tag, values.data() + lane); }
    HWY_INLINE Floats at(Places places, bool) const {
        const Places lane = hn::And(places, hn::Set(places_tag, int{Bvh8Vertices::lane_mask}));
        return hn::GatherIndex(lanes_tag, values.data(), lane);
    }
};

using Table = std::conditional_t<lanes == bvh8_width, TableInRegisters, TableInMemory>;

// Three numbers of each of eight vertices, or of all of them.
struct Moved {
    Floats x, y, z;
};
struct Tables {
    Table x, y, z;

    // Computes three numbers of each vertex by `move` from the coordinates along three axes.
    template <class Move>
    HWY_INLINE Tables(const Bvh8Vertices& vertices, const std::array<std::size_t, 3>& axes, const Move& move) {
        const std::size_t count = vertices.count();
        const float *row_x = vertices.row(axes[0]), *row_y = vertices.row(axes[1]), *row_z = vertices.row(axes[2]);
        const auto moved = [&](std::size_t at) HWY_ATTR {
            return move(hn::LoadU(lanes_tag, row_x + at), hn::LoadU(lanes_tag, row_y + at),
                        hn::LoadU(lanes_tag, row_z + at));
        };
        const auto set = [&](std::size_t block) HWY_ATTR {
            for (std::size_t i = 0; i < bvh8_width; i += lanes) {
                const Moved of = moved(Bvh8Vertices::block_begin(block, count) + i);
                x.set(bvh8_width * block + i, of.x);
                y.set(bvh8_width * block + i, of.y);
                z.set(bvh8_width * block + i, of.z);
            }
        };
        set(0);
        set(1);
        if (count > 2 * bvh8_width) set(2);
    }
};

// The vertices that are the corners of a leaf's triangles, from the i-th on.
class Corners {
public:
    HWY_INLINE Corners(const Bvh8Vertices& vertices, std::size_t i) : has_third_(vertices.count() > 2 * bvh8_width) {
        constexpr hn::Rebind<std::uint16_t, Lanes> words_tag;
        words_ = hn::PromoteTo(places_tag,
                               hn::LoadU(words_tag, static_cast<const std::uint16_t*>(vertices.all_corners()) + i));
    }

    template <int which>
    HWY_INLINE Floats of(const Table& table) const {
        return table.at(hn::ShiftRight<Bvh8Vertices::lane_bits * which>(words_), has_third_);
    }

    // A mask of those that are seen from the front alone.
    HWY_INLINE std::uint32_t front_only() const {
        const Places up_to_sign = hn::ShiftLeft<31 - 3 * Bvh8Vertices::lane_bits>(words_);
        return signs(hn::BitCast(lanes_tag, up_to_sign));
    }

private:
    Places words_;
    bool has_third_;
};

// The corners b, c, a, b of one triangle along each axis, in this order.
struct CornersOfOne {
    FourFloats x, y, z;
};

HWY_INLINE CornersOfOne corners_of(const Bvh8Vertices& vertices, std::size_t place) {
#if HWY_TARGET <= HWY_AVX2  // Looked up in registers, too: 30 instructions fewer.
    constexpr int next = Bvh8Vertices::lane_bits;
    alignas(32) static constexpr std::int32_t shifts[bvh8_width] = {next, 2 * next, 0, next};
    const auto word = static_cast<std::int32_t>(vertices.word(place));
    const Places where = hn::Shr(hn::Set(places_tag, word), hn::Load(places_tag, shifts));
    const Tables unmoved(vertices, {0, 1, 2}, [](Floats x, Floats y, Floats z) HWY_ATTR { return Moved{x, y, z}; });
    const bool has_third = vertices.count() > 2 * bvh8_width;
    const auto row = [&](const Table& table)
                         HWY_ATTR { return FourFloats(_mm256_castps256_ps128(table.at(where, has_third).raw)); };
    return {row(unmoved.x), row(unmoved.y), row(unmoved.z)};
#else
    const auto corners = vertices.corners(place);
    const auto row = [&](std::size_t axis) HWY_ATTR {
        const float* const x = vertices.row(axis);
        return FourFloats{x[corners[1]], x[corners[2]], x[corners[0]], x[corners[1]]};
    };
    return {row(0), row(1), row(2)};
#endif
}

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
