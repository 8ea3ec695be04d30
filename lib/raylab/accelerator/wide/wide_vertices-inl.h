// Compiled once for every instruction set (see wide_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_WIDE_VERTICES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_WIDE_VERTICES_INL_H
#undef RAYLAB_WIDE_VERTICES_INL_H
#else
#define RAYLAB_WIDE_VERTICES_INL_H
#endif

#include "raylab/accelerator/wide/wide_lanes-inl.h"
#include "raylab/accelerator/wide/wide_vertices.h"

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

constexpr hn::RebindToSigned<Lanes> places_tag;
using Places = hn::Vec<hn::RebindToSigned<Lanes>>;

// One number of each of a leaf's vertices, from which corners look up theirs: in registers,
struct TableInRegisters {
    Floats first, second, third;

    HWY_INLINE void set(std::size_t lane, Floats values) {
        (lane < wide ? first : lane < 2 * wide ? second : third) = values;
    }
    HWY_INLINE Floats at(Places places, bool has_third) const {
        Floats found = of_two(places);
        if (has_third) [[unlikely]] {
            const Places lane = hn::And(places, hn::Set(places_tag, int{WideVertices::lane_mask}));
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
#else
        const Places lane = hn::And(places, hn::Set(places_tag, 15));
        return hn::IfThenElse(is_beyond(lane, 7), in_one(second, lane), in_one(first, lane));
#endif
    }
};

// ... or in memory, where the instruction set has fewer than eight lanes.
struct TableInMemory {
    std::array<float, WideVertices::most> values;

    HWY_INLINE void set(std::size_t lane, Floats some) { hn::StoreU(some, lanes_tag, values.data() + lane); }
    HWY_INLINE Floats at(Places places, bool) const {
        const Places lane = hn::And(places, hn::Set(places_tag, int{WideVertices::lane_mask}));
        return hn::GatherIndex(lanes_tag, values.data(), lane);
    }
};

using Table = std::conditional_t<lanes == wide, TableInRegisters, TableInMemory>;

// Three numbers of each of eight vertices, or of all of them.
struct Moved {
    Floats x, y, z;
};
struct Tables {
    Table x, y, z;

    // Computes three numbers of each vertex by `move` from the coordinates along three axes.
    template <class Move>
    HWY_INLINE Tables(const WideVertices& vertices, const std::array<std::size_t, 3>& axes, const Move& move) {
        const std::size_t count = vertices.count();
        const float *row_x = vertices.row(axes[0]), *row_y = vertices.row(axes[1]), *row_z = vertices.row(axes[2]);
        const auto moved = [&](std::size_t at) HWY_ATTR {
            return move(hn::LoadU(lanes_tag, row_x + at), hn::LoadU(lanes_tag, row_y + at), hn::LoadU(lanes_tag, row_z + at));
        };
        const auto set = [&](std::size_t block) HWY_ATTR {
            for (std::size_t i = 0; i < wide; i += lanes) {
                const Moved of = moved(WideVertices::block_begin(block, count) + i);
                x.set(wide * block + i, of.x);
                y.set(wide * block + i, of.y);
                z.set(wide * block + i, of.z);
            }
        };
        set(0);
        set(1);
        if (count > 2 * wide) set(2);
    }
};

// The vertices that are the corners of a leaf's triangles, from the i-th on.
class Corners {
public:
    HWY_INLINE Corners(const WideVertices& vertices, std::size_t i) : has_third_(vertices.count() > 2 * wide) {
        constexpr hn::Rebind<std::uint16_t, Lanes> words_tag;
        words_ = hn::PromoteTo(places_tag,
                               hn::LoadU(words_tag, static_cast<const std::uint16_t*>(vertices.corners()) + i));
    }

    template <int which>
    HWY_INLINE Floats of(const Table& table) const {
        return table.at(hn::ShiftRight<WideVertices::lane_bits * which>(words_), has_third_);
    }

private:
    Places words_;
    bool has_third_;
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
