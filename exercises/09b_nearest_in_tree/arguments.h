#pragma once

#include "raylab/accelerator/bvh/nearest_in_tree.h"
#include "raylab/geometry/box_entry.h"
#include "raylab/geometry/nearest_sphere_hit.h"

#include <algorithm>
#include <span>
#include <vector>

namespace raylab::grading::tree {

// A tree over at most eight spheres, one in each leaf: node i has the children 2 i + 1 and 2 i + 2, and the leaves are
// the last nodes.
inline constexpr std::size_t most_leaves = 8;
inline constexpr std::size_t inputs = 7 + 4 * most_leaves;  // how many leaves (1, 2, 4, 8), the ray, the spheres

/// What the function asks, in its order: a box, or the things of a leaf.
inline constexpr std::size_t most_asked = 64;
inline constexpr std::size_t outputs = 3 + most_asked;  // 1 and t, or 0 0; how often it asked; what it asked first
inline constexpr int leaf_mark = 100;                   // added to the number of a leaf whose things are asked for
inline constexpr int no_node = 99;                      // in place of any number that is no node's

struct Arguments {
    RayOf<double> ray;
    std::vector<SphereOf<double>> spheres;

    int leaves() const { return static_cast<int>(spheres.size()); }
    int nodes() const { return 2 * leaves() - 1; }
    bool is_node(int node) const { return node >= 0 && node < nodes(); }
    bool is_leaf(int node) const { return is_node(node) && node >= leaves() - 1; }
};

struct NodeBox {
    Vec3d low, high;
};

inline NodeBox box_of(const Arguments& given, int node) {
    if (given.is_leaf(node)) {
        const auto& sphere = given.spheres[static_cast<std::size_t>(node - given.leaves() + 1)];
        return {sphere.center - Vec3d(sphere.radius), sphere.center + Vec3d(sphere.radius)};
    }
    const NodeBox a = box_of(given, 2 * node + 1), b = box_of(given, 2 * node + 2);
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

inline std::optional<double> entry_of(const Arguments& given, int node) {
    const NodeBox box = box_of(given, node);
    return box_entry(given.ray, box.low, box.high);
}

inline std::optional<double> hit_of(const Arguments& given, int leaf) {
    return nearest_sphere_hit(given.ray, given.spheres[static_cast<std::size_t>(leaf - given.leaves() + 1)]);
}

inline Arguments arguments(std::span<const double> in) {
    const auto vector = [&](std::size_t i) { return Vec3d{in[i], in[i + 1], in[i + 2]}; };
    Arguments given{{vector(1), vector(4), {0, 1e9}}, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(in[0]); ++i)
        given.spheres.push_back({vector(7 + 4 * i), in[10 + 4 * i]});
    return given;
}

inline std::vector<double> as_input(const Arguments& given) {
    const auto& [ray, spheres] = given;
    std::vector<double> in{static_cast<double>(spheres.size())};
    const auto put = [&](const Vec3d& v) { in.insert(in.end(), {v.x, v.y, v.z}); };
    put(ray.origin);
    put(ray.direction);
    for (const auto& sphere : spheres) {
        put(sphere.center);
        in.push_back(sphere.radius);
    }
    in.resize(inputs);
    return in;
}

/// Answers one case with a function of the slot's type. What is no node has no box, no children and no things.
inline void answer(decltype(&nearest_in_tree) function, std::span<const double> in, std::span<double> out) {
    const Arguments given = arguments(in);
    std::vector<int> asked;
    const auto note = [&](int mark, int node) { asked.push_back(mark + (given.is_node(node) ? node : no_node)); };
    const auto t = function({.entry = [&](int node) -> std::optional<double> {
                                 note(0, node);
                                 return given.is_node(node) ? entry_of(given, node) : std::nullopt;
                             },
                             .children = [&](int node) -> std::optional<std::array<int, 2>> {
                                 if (!given.is_node(node) || given.is_leaf(node)) return std::nullopt;
                                 return std::array{2 * node + 1, 2 * node + 2};
                             },
                             .hit = [&](int leaf) -> std::optional<double> {
                                 note(leaf_mark, leaf);
                                 return given.is_leaf(leaf) ? hit_of(given, leaf) : std::nullopt;
                             }});
    std::ranges::fill(out, -1);
    out[0] = t ? 1 : 0;
    out[1] = t.value_or(0);
    out[2] = static_cast<double>(asked.size());
    for (std::size_t i = 0; i < std::min(asked.size(), most_asked); ++i) out[3 + i] = asked[i];
}

}  // namespace raylab::grading::tree
