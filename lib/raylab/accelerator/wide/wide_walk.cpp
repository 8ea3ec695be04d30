#include "raylab/accelerator/wide/wide_walk.h"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

// Compiled once for every instruction set named by Highway; which one runs is decided where the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raylab/accelerator/wide/wide_walk.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Eight floats at once, or as many of them as there are.
using Lanes = hn::CappedTag<float, wide>;
constexpr Lanes lanes_tag;
constexpr std::size_t lanes = hn::MaxLanes(lanes_tag);
using Floats = hn::Vec<Lanes>;
using Mask = hn::Mask<Lanes>;

HWY_INLINE Floats all(float x) { return hn::Set(lanes_tag, x); }

HWY_INLINE std::uint32_t bits(Mask mask) {
    std::array<std::uint8_t, 8> bytes{};
    hn::StoreMaskBits(lanes_tag, mask, bytes.data());
    return bytes[0];
}

// Where the ray enters each of a node's boxes, and which it meets.
struct Met {
    alignas(32) std::array<float, wide> entry;
    std::uint32_t mask = 0;
};

// The ray as registers hold it while it walks.
class BoxLanes {
public:
    HWY_INLINE explicit BoxLanes(const WideRay& ray) : ray_(ray) {}

    HWY_INLINE void meet(const WideNode& node, float end, Met& met) const {
        met.mask = 0;
        for (std::size_t i = 0; i < wide; i += lanes) {
            const auto in = [&](std::size_t axis) {
                const Floats plane = hn::Load(lanes_tag, node.planes[ray_.near_plane[axis]].data() + i);
                return hn::Mul(hn::Sub(plane, all(ray_.near_origin[axis])), all(ray_.near_inverse[axis]));
            };
            const auto out = [&](std::size_t axis) {
                const Floats plane = hn::Load(lanes_tag, node.planes[ray_.far_plane[axis]].data() + i);
                return hn::Mul(hn::Sub(plane, all(ray_.far_origin[axis])), all(ray_.far_inverse[axis]));
            };
            const Floats entry = hn::Max(hn::Max(in(0), in(1)), hn::Max(in(2), all(ray_.start)));
            const Floats exit = hn::Min(hn::Min(out(0), out(1)), hn::Min(out(2), all(end)));
            hn::Store(entry, lanes_tag, met.entry.data() + i);
            met.mask |= bits(hn::Le(entry, exit)) << i;
        }
    }

private:
    const WideRay& ray_;
};

// A leaf's triangles, seen from the ray's origin and sheared along it.
struct Sheared {
    Floats ax, ay, bx, by, cx, cy;
};

HWY_INLINE Sheared sheared(const WideRay& ray, const float* rows, std::size_t count) {
    const auto row = [&](std::size_t vertex, std::size_t axis) {
        return hn::Sub(hn::LoadU(lanes_tag, rows + (3 * vertex + ray.axes[axis]) * count), all(ray.origin[axis]));
    };
    const Floats az = row(0, 2), bz = row(1, 2), cz = row(2, 2);
    const Floats sx = all(ray.shear[0]), sy = all(ray.shear[1]);
    const auto along = [](Floats x, Floats shear, Floats z) { return hn::Sub(x, hn::Mul(shear, z)); };
    return {along(row(0, 0), sx, az), along(row(0, 1), sy, az), along(row(1, 0), sx, bz),
            along(row(1, 1), sy, bz), along(row(2, 0), sx, cz), along(row(2, 1), sy, cz)};
}

// Which of a leaf's triangles are not surely missed: the areas' signs are not surely mixed. A NaN leaves it open.
HWY_INLINE std::uint32_t not_missed(const WideRay& ray, const float* rows, std::size_t count) {
    std::uint32_t open = 0;
    for (std::size_t i = 0; i < count; i += lanes) {
        const Sheared s = sheared(ray, rows + i, count);
        const auto area = [](Floats px, Floats py, Floats qx, Floats qy) { return hn::Sub(hn::Mul(px, qy), hn::Mul(py, qx)); };
        const Floats u = area(s.cx, s.cy, s.bx, s.by), v = area(s.ax, s.ay, s.cx, s.cy), w = area(s.bx, s.by, s.ax, s.ay);
        const auto larger = [](Floats p, Floats q) { return hn::Max(hn::Abs(p), hn::Abs(q)); };
        const Floats r = hn::Max(hn::Max(larger(s.ax, s.ay), larger(s.bx, s.by)), larger(s.cx, s.cy));
        const Floats error = hn::Add(hn::Mul(r, hn::Add(hn::Mul(r, all(ray.error_quadratic)), all(ray.error_linear))),
                                     all(ray.error_constant));
        const Mask missed = hn::And(hn::Lt(hn::Min(hn::Min(u, v), w), hn::Neg(error)), hn::Gt(hn::Max(hn::Max(u, v), w), error));
        open |= (~bits(missed) & ((1u << lanes) - 1)) << i;
    }
    return open & ((1u << count) - 1);
}

// Pluecker's test from the ray's origin, in floats, and t: the nearest hit of a leaf, if any comes before the end.
HWY_INLINE bool plain_hit(const WideRay& ray, const std::array<float, 3>& direction, const float* rows, std::size_t count,
                          float& end, std::size_t& place) {
    bool hit = false;
    for (std::size_t i = 0; i < count; i += lanes) {
        const auto row = [&](std::size_t vertex, std::size_t axis) {
            return hn::Sub(hn::LoadU(lanes_tag, rows + i + (3 * vertex + ray.axes[axis]) * count), all(ray.origin[axis]));
        };
        const Floats ax = row(0, 0), ay = row(0, 1), az = row(0, 2), bx = row(1, 0), by = row(1, 1), bz = row(1, 2);
        const Floats cx = row(2, 0), cy = row(2, 1), cz = row(2, 2);
        const Floats dx = all(direction[0]), dy = all(direction[1]), dz = all(direction[2]);
        const auto area = [](Floats p, Floats q, Floats r, Floats s) { return hn::Sub(hn::Mul(p, q), hn::Mul(r, s)); };
        const auto dot = [](Floats x, Floats y, Floats z, Floats p, Floats q, Floats r) {
            return hn::Add(hn::Add(hn::Mul(x, p), hn::Mul(y, q)), hn::Mul(z, r));
        };
        const Floats nx = area(by, cz, bz, cy), ny = area(bz, cx, bx, cz), nz = area(bx, cy, by, cx);
        const Floats u = dot(nx, ny, nz, dx, dy, dz);
        const Floats v = dot(area(cy, az, cz, ay), area(cz, ax, cx, az), area(cx, ay, cy, ax), dx, dy, dz);
        const Floats w = dot(area(ay, bz, az, by), area(az, bx, ax, bz), area(ax, by, ay, bx), dx, dy, dz);
        const Floats least = hn::Min(hn::Min(u, v), w), most = hn::Max(hn::Max(u, v), w), zero = hn::Zero(lanes_tag);
        const Mask inside = hn::Or(hn::Ge(least, zero), hn::Le(most, zero));
        std::uint32_t candidates = bits(inside) & ((1u << (count - i)) - 1);
        if (candidates == 0) continue;
        alignas(32) std::array<float, wide> t;
        hn::Store(hn::Div(dot(nx, ny, nz, ax, ay, az), hn::Add(hn::Add(u, v), w)), lanes_tag, t.data());
        for (; candidates != 0; candidates &= candidates - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(candidates));
            if (!(t[lane] >= ray.start && t[lane] <= end)) continue;
            end = t[lane];
            place = i + lane;
            hit = true;
        }
    }
    return hit;
}

struct Waiting {
    WideChild child;
    float entry;
};

// The children met, farthest first, on the stack: the last is the nearest.
HWY_INLINE Waiting* push(const WideNode& node, Met& met, Waiting* top) {
    Waiting* const first = top;
    for (; met.mask != 0; met.mask &= met.mask - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(met.mask));
        const Waiting child{node.children[i], met.entry[i]};
        Waiting* at = top++;
        for (; at != first && (at - 1)->entry < child.entry; --at) *at = *(at - 1);
        *at = child;
    }
    return top;
}

enum class WideTest { exact, plain };

template <WideTest test>
HWY_INLINE std::optional<WideHit> walk_with(const WideNodes& tree, WideRay& ray, WideLeaves& leaves, Traversal& traversal) {
    std::optional<WideHit> hit;
    if (tree.nodes.empty()) return hit;
    std::array<Waiting, WideNodes::max_depth * (wide - 1) + 1> stack;
    const BoxLanes boxes(ray);
    std::uint64_t steps = 0, triangles = 0;
    Met met;
    Waiting* top = stack.data();
    WideChild next = WideChild::node(0);
    while (true) {
        if (next.is_node()) {
            const WideNode& node = tree.nodes[next.index()];
            ++steps;
            boxes.meet(node, ray.end, met);
            if (met.mask != 0) {
                if ((met.mask & (met.mask - 1)) == 0) {
                    next = node.children[static_cast<std::size_t>(std::countr_zero(met.mask))];
                    continue;
                }
                top = push(node, met, top);
                next = (--top)->child;
                continue;
            }
        } else if (next.kind() == WideChild::Kind::triangles) {
            const float* rows = tree.corners.data() + 9 * next.first();
            const std::size_t count = next.count();
            triangles += count;
            if constexpr (test == WideTest::exact) {
                for (std::uint32_t open = not_missed(ray, rows, count); open != 0; open &= open - 1)
                    ray.set_end(leaves.triangle(next, static_cast<std::size_t>(std::countr_zero(open))));
            } else {
                std::size_t place = 0;
                if (plain_hit(ray, ray.direction, rows, count, ray.end, place)) hit = WideHit{next, place, ray.end};
            }
        } else {
            ray.set_end(leaves.others(next));
        }
        do {
            if (top == stack.data()) {
                traversal.steps += steps;
                traversal.box_tests += wide * steps;
                traversal.primitive_tests += triangles;
                return hit;
            }
            --top;
        } while (!(top->entry <= ray.end));
        next = top->child;
    }
}

void walk_exact(const WideNodes& tree, WideRay& ray, WideLeaves& leaves, Traversal& traversal) {
    walk_with<WideTest::exact>(tree, ray, leaves, traversal);
}

std::optional<WideHit> walk_plain(const WideNodes& tree, WideRay& ray, WideLeaves& leaves, Traversal& traversal) {
    return walk_with<WideTest::plain>(tree, ray, leaves, traversal);
}

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raylab {

HWY_EXPORT(walk_exact);
HWY_EXPORT(walk_plain);

void walk(const WideNodes& tree, WideRay& ray, WideLeaves& leaves, Traversal& traversal) {
    HWY_DYNAMIC_DISPATCH(walk_exact)(tree, ray, leaves, traversal);
}

std::optional<WideHit> plain_walk(const WideNodes& tree, WideRay& ray, WideLeaves& leaves, Traversal& traversal) {
    return HWY_DYNAMIC_DISPATCH(walk_plain)(tree, ray, leaves, traversal);
}

}  // namespace raylab
#endif
