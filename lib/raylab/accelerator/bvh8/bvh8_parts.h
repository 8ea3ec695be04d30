#pragma once

#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/geometry/shapes.h"
#include "raylab/geometry/vector.h"
#include "raylab/number/four_floats.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

// The types from which bvh8 is built: boxes as vectors of four floats, of which the fourth is not used, parts of
// the primitives, and bins.

namespace raylab::bvh8_parts {

inline constexpr float infinity = std::numeric_limits<float>::infinity();
// Clamps everything farther out, so that areas are at most 3 * 2^124.
inline constexpr float beyond = 2 * Bvh8Nodes::largest;

struct Extent {
    FourFloats min{infinity, infinity, infinity, infinity}, max{-infinity, -infinity, -infinity, -infinity};

    void add(const Extent& other) {
        min = smaller(min, other.min);
        max = larger(max, other.max);
    }
    void add(FourFloats point) {
        min = smaller(min, point);
        max = larger(max, point);
    }
    float half_area() const {
        const FourFloats d = max - min;
        return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    }
};

enum class Kind { triangle, other };

// A primitive to be sorted: its box, and in the two fourth components its number.
class Reference {
public:
    Reference() = default;  // without values, so that room for references is not written before it is used
    Reference(FourFloats min, FourFloats max, std::size_t number, Kind kind)
        : min_(within_reach(min)), max_(within_reach(max)) {
        min_[3] = std::bit_cast<float>(static_cast<std::uint32_t>(number) + normal);
        max_[3] = kind == Kind::triangle ? 1.0f : 2.0f;
    }

    Extent box() const { return {min_, max_}; }
    /// The same primitive, of which only the part inside a smaller box is meant.
    Reference in(const Extent& box) const {
        Reference part = *this;
        for (int axis = 0; axis < 3; ++axis) {
            part.min_[axis] = box.min[axis];
            part.max_[axis] = box.max[axis];
        }
        return part;
    }
    FourFloats twice_center() const { return min_ + max_; }
    std::uint32_t number() const { return std::bit_cast<std::uint32_t>(float{min_[3]}) - normal; }
    bool is_triangle() const { return max_[3] == 1.0f; }

private:
    // The bits of 2^-31, to which the number (below 2^27) is added: the number alone would be a subnormal float, and
    // computing with it would be slow.
    static constexpr std::uint32_t normal = 0x30000000;
    // (With 0 added, -0 is 0: the smallest of both depends on their order.)
    static FourFloats within_reach(FourFloats x) {
        return larger(smaller(x, FourFloats{} + beyond), FourFloats{} - beyond) + FourFloats{};
    }

    FourFloats min_, max_;
};

inline float area(const Triangle& triangle) {
    return glm::length(cross(triangle.b - triangle.a, triangle.c - triangle.a)) / 2;
}

inline FourFloats four(const Vec3f& v) { return FourFloats{v.x, v.y, v.z, 0}; }

// A contiguous range of the references, with free places after it for those that splits add.
struct ReferenceRange {
    std::size_t begin = 0, end = 0;
    std::size_t room = 0;
    Extent box{}, centers{};  // the bounds of their boxes, and of twice their centers

    std::size_t size() const { return end - begin; }
    void add(const Reference& reference) {
        box.add(reference.box());
        centers.add(reference.twice_center());
    }
    void add(const ReferenceRange& other) {  // its bounds alone
        box.add(other.box);
        centers.add(other.centers);
    }
};

inline constexpr int max_bins = 32;

struct Bin {
    Extent box;
    std::uint32_t count = 0;

    void add(const Bin& other) {
        box.add(other.box);
        count += other.count;
    }
    float work() const { return work_of(box, count); }
    // Eight triangles are tested as quickly as one.
    static float work_of(const Extent& box, std::size_t count) {
        return count == 0 ? 0 : box.half_area() * static_cast<float>((count + bvh8_width - 1) / bvh8_width);
    }
};

// The expected work of a leaf, where that of a node is one.
inline constexpr float leaf_work = 2;

// How centers are assigned to bins: bin = (2 center - low) scale, on each axis.
struct Binning {
    FourFloats low, scale;
    int count;

    explicit Binning(const ReferenceRange& part)
        : low(part.centers.min), count(std::min(max_bins, 4 + static_cast<int>(part.size() / 20))) {
        const FourFloats width = part.centers.max - part.centers.min;
        const float bins = 0.99999f * static_cast<float>(count);
        for (int axis = 0; axis < 3; ++axis)
            scale[axis] = width[axis] > 0 ? std::min(bins / width[axis], std::numeric_limits<float>::max()) : 0;
        scale[3] = 0;
    }
    FourInts of(const Reference& reference) const {
        return __builtin_convertvector((reference.twice_center() - low) * scale, FourInts);
    }
};

struct Split {
    int axis = 0, bin = 0;  // bins below this one go left
    float cost = infinity;
};

}  // namespace raylab::bvh8_parts
