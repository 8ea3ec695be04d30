#pragma once

#include "truth.h"
#include "whole_numbers.h"

#include "raylab/geometry/degree.h"

// The cases. Nothing that decides is near where it changes, except in whole numbers.

namespace raylab::grading::mesh_hit {

inline Vec3d tilted(Dice& dice, const Vec3d& axis, double degrees) {
    const Vec3d aside = glm::normalize(cross(axis, dice.direction()));
    return std::cos(degrees * degree) * axis + std::sin(degrees * degree) * aside;
}

/// Weights that are not nearly equal and not nearly 0.
inline void place(Dice& dice, InterpolatedHit& hit) {
    for (;;) {
        hit.u = dice.in(0.08, 0.84);
        hit.v = dice.in(0.08, 0.84);
        const double w = 1 - hit.u - hit.v;
        const double nearest = std::min({std::abs(w - hit.u), std::abs(hit.u - hit.v), std::abs(hit.v - w)});
        if (w > 0.08 && nearest > 0.08) return;
    }
}

inline Model any_model(Dice& dice, const Vec3d& around) {
    Model model{tilted(dice, around, dice.in(10, 50)), {}, dice.in(0.02, 0.2), dice.in(0.3, 0.9), dice.in(0.3, 0.9), 0};
    model.shininess = whole(dice, 3, 20);
    return model;
}

/// How far the vertices' normals lean from the triangle's, and the viewer from the side that is seen, in degrees.
struct Leaning {
    double least, most, viewer_least, viewer_most;
};

inline Arguments leaning(Dice& dice, const Leaning& by, double side) {
    const Vec3d face = dice.direction();
    InterpolatedHit hit{{}, face, 0, 0, {}};
    for (Vec3d& normal : hit.normals) normal = tilted(dice, face, dice.in(by.least, by.most));
    place(dice, hit);
    hit.to_viewer = tilted(dice, side * face, dice.in(by.viewer_least, by.viewer_most)) * dice.in(0.5, 4);
    Arguments given{hit, any_model(dice, side * face)};
    given.model.to_viewer = glm::normalize(hit.to_viewer);
    return given;
}

/// Whether the light is well before the mixed normal and the vertices' and lights them differently, so that each
/// careless answer is another number.
inline bool is_telling(const Arguments& given) {
    const Ingredients made = ingredients(given.hit);
    const auto lit = [&](const Vec3d& normal) { return dot(normal, given.model.to_light) > 0.03; };
    const auto [gouraud, phong] = truth(given);
    return std::ranges::all_of(made.normals, lit) && lit(glm::normalize(mixed(made))) &&
           std::abs(gouraud - phong) > 1e-3;
}

template <class Wanted>
Arguments one_where(Dice& dice, const Leaning& by, double side, const Wanted& wanted) {
    for (;;)
        if (const Arguments given = leaning(dice, by, side); wanted(given)) return given;
}

inline Arguments from_the_front(Dice& dice) { return one_where(dice, {10, 40, 5, 70}, 1, is_telling); }
inline Arguments from_behind(Dice& dice) { return one_where(dice, {10, 40, 5, 70}, -1, is_telling); }

/// How a normal of the seen side stands to the viewer: below 0 it looks away.
inline double facing(const Arguments& given, const Vec3d& normal) { return dot(normal, given.model.to_viewer); }

/// The triangle is seen, and one or two of its vertices' normals look away.
inline Arguments vertex_looks_away(Dice& dice) {
    return one_where(dice, {20, 50, 60, 80}, sign(dice), [](const Arguments& given) {
        const auto made = ingredients(given.hit);
        const auto away = std::ranges::count_if(made.normals, [&](const Vec3d& n) { return facing(given, n) < -0.05; });
        return is_telling(given) && away >= 1 && away <= 2 && facing(given, mixed(made)) > 0.05;
    });
}

/// The triangle is seen, and the mixed normal looks away.
inline Arguments mixed_looks_away(Dice& dice) {
    return one_where(dice, {20, 50, 70, 85}, sign(dice), [](const Arguments& given) {
        return is_telling(given) && facing(given, mixed(ingredients(given.hit))) < -0.05;
    });
}

/// Normals far apart: what is mixed is much shorter than its parts.
inline Arguments strongly_bent(Dice& dice) {
    return one_where(dice, {60, 75, 5, 60}, sign(dice), [](const Arguments& given) {
        const double length = glm::length(mixed(ingredients(given.hit)));
        return length > 0.2 && length < 0.6 && dot(mixed(ingredients(given.hit)), given.model.to_light) > 0.03 &&
               std::abs(truth(given).gouraud - truth(given).phong) > 1e-3;
    });
}

/// Hardly anything is left of the mixed normal, and it counts: two normals in nearly opposite directions.
inline Arguments nearly_cancelling(Dice& dice) {
    for (;;) {
        Arguments given = leaning(dice, {20, 60, 5, 60}, sign(dice));
        InterpolatedHit& hit = given.hit;
        const Vec3d left = tilted(dice, hit.face, dice.in(20, 50));  // where the mixed normal will point
        const double length = std::exp(dice.in(std::log(2e-5), std::log(0.08))), bend = 2 * length;
        hit.normals[0] = glm::normalize(cross(left, dice.direction()));
        hit.normals[1] = std::sin(bend) * left - std::cos(bend) * hit.normals[0];
        hit.u = 0.5 + dice.in(-0.25, 0.25) * length;
        hit.v = 0;
        const Vec3d normal = glm::normalize(mixed(ingredients(hit)));
        const auto toward = [&](const Vec3d& n) { return dot(n, given.model.to_light); };
        if (toward(normal) > 0.1 && std::abs(toward(normal) - side_of(hit) * toward(hit.face)) > 0.03) return given;
    }
}

/// A highlight between the vertices, brighter than 1: their own normals lie around it.
inline Arguments highlight_between(Dice& dice) {
    return one_where(dice, {25, 35, 5, 40}, sign(dice), [](Arguments given) { return is_telling(given); });
}
inline Arguments with_highlight(Dice& dice) {
    for (;;) {
        Arguments given = highlight_between(dice);
        Model& model = given.model;
        const Vec3d normal = glm::normalize(mixed(ingredients(given.hit)));
        model.to_light = tilted(dice, 2 * dot(normal, model.to_viewer) * normal - model.to_viewer, 2);
        model.specular = model.diffuse = 0.9;
        model.shininess = whole(dice, 30, 60);
        if (is_telling(given) && truth(given).phong > 1.1) return given;
    }
}

/// A third of the way or two thirds along an edge: the opposite vertex has no weight.
inline Arguments on_an_edge(Dice& dice) {
    Arguments given = heads(dice) ? from_the_front(dice) : from_behind(dice);
    const int opposite = whole(dice, 0, 2);
    const double weight = dice.in(0.2, 0.4);
    given.hit.u = opposite == 1 ? 0 : weight;
    given.hit.v = opposite == 0 ? 1 - weight : opposite == 1 ? weight : 0;
    return given;
}

inline Arguments at_a_vertex(Dice& dice) {
    Arguments given = heads(dice) ? from_the_front(dice) : from_behind(dice);
    const int vertex = whole(dice, 0, 2);
    given.hit.u = vertex == 1;
    given.hit.v = vertex == 2;
    return given;
}

/// Halfway between two vertices whose normals are opposite, along an axis: the sum is zero, exactly, by any way to mix.
inline Arguments cancelling(Dice& dice) {
    const int axis = whole(dice, 0, 2);
    const double up = sign(dice), side = sign(dice);
    InterpolatedHit hit{{}, along(axis + 1, sign(dice)), 0, 0, {}};
    const int third = whole(dice, 0, 2);
    hit.normals = {along(axis, up), along(axis, -up), along(axis, -up)};
    if (third == 1) std::swap(hit.normals[1], hit.normals[2]);
    if (third == 0) hit.normals[1] = along(axis, up);
    hit.normals[static_cast<std::size_t>(third)] = along(axis + 2, sign(dice));
    hit.u = third == 1 ? 0 : 0.5;
    hit.v = third == 2 ? 0 : 0.5;
    const Vec3d seen = side * hit.face;
    hit.to_viewer = (4.0 * seen + along(axis + 2, whole(dice, 1, 3))) * power_of_two(dice, -1, 2);
    Arguments given{hit, any_model(dice, seen)};
    given.model.to_viewer = glm::normalize(hit.to_viewer);
    return given;
}

inline Arguments cancels_but_for_rounding(Dice& dice) {
    Arguments given = cancelling(dice);
    for (Vec3d& normal : given.hit.normals) normal += dice.point(-1e-15, 1e-15);
    return given;
}

}  // namespace raylab::grading::mesh_hit
