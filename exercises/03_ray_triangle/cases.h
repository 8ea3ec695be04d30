#pragma once

#include "arguments.h"
#include "case.h"
#include "dice.h"

#include "raylab/geometry/oracle/oracle.h"

#include <cmath>
#include <limits>

// The kinds of rays and triangles in the cases, but for those on a boundary.

namespace raylab::grading::ray_triangle {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline Case make(const std::string& group, Case::Kind kind, const RayOf<double>& ray,
                 const TriangleOf<double>& triangle) {
    return {group, kind, as_input({ray, triangle})};
}

inline TriangleOf<double> somewhere(Dice& dice) {
    const Vec3d middle = dice.point(-2, 2);
    const auto corner = [&] { return as_floats(middle + dice.point(-1, 1)); };
    const Vec3d a = corner();
    const Vec3d b = corner();
    return {a, b, corner()};
}

inline Vec3d at(const TriangleOf<double>& triangle, double u, double v) {
    return (1 - u - v) * triangle.a + u * triangle.b + v * triangle.c;
}

/// A ray whose line intersects the triangle's plane at (u, v), where `length` is that of its direction.
inline Case aimed(Dice& dice, const std::string& group, double u, double v, double length) {
    const auto triangle = somewhere(dice);
    const Vec3d target = at(triangle, u, v);
    const Vec3d origin = as_floats(target + dice.direction() * dice.in(1, 5));
    const Vec3d direction = as_floats((target - origin) * (length / glm::length(target - origin)));
    return make(group, Case::Kind::graded, {origin, direction, {0, infinity}}, triangle);
}

inline Case inside(Dice& dice, const std::string& group, double length) {
    const double u = dice.in(0.05, 0.9);
    const double v = dice.in(0.02, 0.98) * (0.95 - u);
    return aimed(dice, group, u, v, length);
}

/// A point beyond one edge, which only one of the three tests detects.
inline Case beside(Dice& dice) {
    const double along = dice.in(0.1, 0.9);
    const double out = dice.in(0.05, 0.6);
    const double edge = dice.in(0, 3);
    if (edge < 1) return aimed(dice, "beside, u < 0", -out, along, 1);
    if (edge < 2) return aimed(dice, "beside, v < 0", along, -out, 1);
    return aimed(dice, "beside, u + v > 1", along + out, 1 - along + out / 2, 1);
}

/// So close to an edge that a tolerance of a hundred-thousandth takes it for a hit.
inline Case just_beside(Dice& dice) {
    const std::string group = "a few millionths beside an edge";
    const double along = dice.in(0.1, 0.9), out = dice.in(4e-6, 9e-6), edge = dice.in(0, 3);
    if (edge < 1) return aimed(dice, group, -out, along, 1);
    if (edge < 2) return aimed(dice, group, along, -out, 1);
    return aimed(dice, group, along + out, 1 - along, 1);
}

inline Case behind(Dice& dice) {
    auto question = inside(dice, "behind the ray", 1);
    for (const std::size_t i : {3u, 4u, 5u}) question.input[i] = -question.input[i];
    return question;
}

inline Case cut(Dice& dice, const std::string& group, double length) {
    auto question = inside(dice, group, length);
    const auto [ray, triangle] = arguments(question.input);
    const double t = oracle::intersect(ray, triangle).hit() ? oracle::intersect(ray, triangle).t->nearest() : 1;
    const bool begins_late = dice.in(0, 1) < 0.5;
    question.input[begins_late ? 6 : 7] = begins_late ? t * 1.25 : t * 0.75;
    return question;
}

/// What is behind the ray's start counts where its range says so.
inline Case begins_before_start(Dice& dice) {
    auto question = behind(dice);
    question.group = "range that begins before the start";
    question.input[6] = dice.in(0, 1) < 0.5 ? -100 : -infinity;
    return question;
}

inline Case shrunk(Case question, const std::string& group) {
    question.group = group;
    for (std::size_t i = 0; i < 3; ++i) question.input[i] *= 1e-4;
    for (std::size_t i = 8; i < inputs; ++i) question.input[i] *= 1e-4;
    return question;
}

/// From a few tenths of a millimetre, or from a few metres: whether a hit is near has nothing to do with it.
inline Case small(Dice& dice) {
    auto question = shrunk(inside(dice, "", 1), "a triangle of a tenth of a millimetre");
    const double back = dice.in(0, 1) < 0.5 ? 0 : dice.in(1, 5);
    for (std::size_t i = 0; i < 3; ++i) question.input[i] -= back * question.input[3 + i];
    return question;
}

/// Areas here are less than any fixed tolerance.
inline Case beside_small(Dice& dice) { return shrunk(beside(dice), "beside a triangle of a tenth of a millimetre"); }

/// A ray in the triangle's plane: coplanar rays miss, whatever they cross.
inline Case coplanar(Dice& dice) {
    const double height = std::round(dice.in(-4, 4));
    const double shift = std::round(dice.in(-1, 1)) / 4;
    return make("in the triangle's plane", Case::Kind::graded, {{-5, shift, height}, {1, 0, 0}, {0, infinity}},
                {{-1, -1, height}, {2, -1, height}, {0, 2, height}});
}

inline Case at_edge(Dice& dice) {
    auto question = aimed(dice, "aimed at an edge", dice.in(0.1, 0.9), 0, 1);
    question.kind = Case::Kind::adversarial;
    return question;
}

inline Case at_vertex(Dice& dice) {
    auto question = aimed(dice, "aimed at a vertex", 0, 0, 1);
    question.kind = Case::Kind::adversarial;
    return question;
}

inline Case sliver(Dice& dice) {
    const Vec3d a = as_floats(dice.point(-1, 1));
    const Vec3d b = as_floats(dice.point(-1, 1));
    const Vec3d aside = glm::normalize(cross(b - a, dice.direction()));
    const TriangleOf<double> triangle{a, b, as_floats((a + b) * 0.5 + aside * 1e-5)};
    const Vec3d target = at(triangle, dice.in(0.1, 0.4), dice.in(0.1, 0.4));
    const Vec3d origin = as_floats(target + dice.direction() * 3.0);
    return make("a sliver, 1e-5 high", Case::Kind::adversarial, {origin, as_floats(target - origin), {0, infinity}},
                triangle);
}

}  // namespace raylab::grading::ray_triangle
