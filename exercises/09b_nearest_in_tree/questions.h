#pragma once

#include "truth.h"
#include "whole_numbers.h"

#include "raylab/geometry/vector.h"

// The cases: spheres, sorted into a tree by their places, and rays that meet what the case is about.

namespace raylab::grading::tree {

/// Halves the spheres by their centres, along one axis after the other; which half comes first is left to chance, so
/// that the left child is the nearer one no more often than the right one.
inline void sort_spheres(Dice& dice, std::span<SphereOf<double>> spheres, int axis) {
    if (spheres.size() < 2) return;
    const double turn = sign(dice);
    std::ranges::sort(spheres, {}, [&](const auto& sphere) { return turn * sphere.center[axis % 3]; });
    sort_spheres(dice, spheres.first(spheres.size() / 2), axis + 1);
    sort_spheres(dice, spheres.subspan(spheres.size() / 2), axis + 1);
}

inline Arguments any_tree(Dice& dice, int leaves) {
    Arguments given;
    for (int i = 0; i < leaves; ++i) {
        const Vec3d center = dice.point(-4, 4);
        given.spheres.push_back({center, dice.in(0.6, 2.2)});
    }
    sort_spheres(dice, given.spheres, whole(dice, 0, 2));
    const Vec3d origin = 12.0 * dice.direction();
    const Vec3d target = dice.point(-3, 3);
    given.ray = {origin, (target - origin) * dice.in(0.05, 2), {0, 1e9}};
    return given;
}

/// The first of many that is as wanted.
template <class Wanted>
Arguments one_where(Dice& dice, int leaves, const Wanted& wanted) {
    for (;;)
        if (const Arguments given = any_tree(dice, leaves); wanted(given)) return given;
}

/// The leaves whose boxes the ray enters, in the order in which it does.
inline std::vector<int> entered_leaves(const Arguments& given) {
    std::vector<int> leaves;
    for (int leaf = given.leaves() - 1; leaf < given.nodes(); ++leaf)
        if (entry_of(given, leaf)) leaves.push_back(leaf);
    std::ranges::sort(leaves, {}, [&](int leaf) { return *entry_of(given, leaf); });
    return leaves;
}

inline bool misses_root(const Arguments& given) { return !entry_of(given, 0); }

inline bool hits_in_vain(const Arguments& given) { return entered_leaves(given).size() >= 2 && !truth(given); }

/// The leaf that is entered first holds nothing that is hit, and a later one does.
inline bool first_is_empty(const Arguments& given) {
    const auto leaves = entered_leaves(given);
    return !leaves.empty() && !hit_of(given, leaves[0]) && truth(given);
}

/// The leaf that is entered first holds a hit, and a later one a nearer hit.
inline bool first_is_not_nearest(const Arguments& given) {
    const auto leaves = entered_leaves(given);
    if (leaves.empty()) return false;
    const auto hit = hit_of(given, leaves[0]);
    return hit && *hit > *truth(given);
}

/// Three leaves at least are entered beyond the nearest hit.
inline bool hides_others(const Arguments& given) {
    const auto nearest = truth(given);
    const auto leaves = entered_leaves(given);
    return nearest && std::ranges::count_if(leaves, [&](int leaf) { return *entry_of(given, leaf) > *nearest; }) >= 3;
}

inline Arguments anywhere(Dice& dice) { return any_tree(dice, 8); }
inline Arguments beside_the_root(Dice& dice) { return one_where(dice, 8, misses_root); }
inline Arguments in_vain(Dice& dice) { return one_where(dice, 8, hits_in_vain); }
inline Arguments empty_first(Dice& dice) { return one_where(dice, 8, first_is_empty); }
inline Arguments overlapping(Dice& dice) { return one_where(dice, 8, first_is_not_nearest); }
inline Arguments hiding(Dice& dice) { return one_where(dice, 8, hides_others); }
inline Arguments few_leaves(Dice& dice) { return any_tree(dice, heads(dice) ? 2 : 4); }
inline Arguments single_leaf(Dice& dice) {
    Arguments given = any_tree(dice, 1);
    const double aside = dice.in(0, 2);
    given.ray.direction = given.spheres[0].center + Vec3d(0.6 * aside * given.spheres[0].radius) - given.ray.origin;
    return given;
}

/// The ray begins in many of the boxes, so that their entries are all 0.
inline Arguments from_inside(Dice& dice) {
    Arguments given = any_tree(dice, 8);
    given.ray.origin = dice.point(-2.5, 2.5);
    given.ray.direction = dice.direction();
    return given;
}

/// A direction so short that t is in millions, and not beyond a thousand million.
inline Arguments far_away(Dice& dice) {
    Arguments given = overlapping(dice);
    given.ray.direction *= 0x1p-20;
    return given;
}

/// Two leaves hold the same ball, up to some roundings: rounding decides which of their boxes is entered first.
inline Arguments nearly_twice(Dice& dice) {
    Arguments given = any_tree(dice, 8);
    const auto one = static_cast<std::size_t>(whole(dice, 0, 3)), other = static_cast<std::size_t>(whole(dice, 4, 7));
    given.spheres[other] = given.spheres[one];
    given.spheres[other].center += dice.point(-1e-15, 1e-15);
    given.ray.direction = (given.spheres[one].center - given.ray.origin) * dice.in(0.05, 2);
    return given;
}

}  // namespace raylab::grading::tree
