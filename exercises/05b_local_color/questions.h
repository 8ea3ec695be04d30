#pragma once

#include "truth.h"
#include "whole_numbers.h"

#include "raylab/geometry/degree.h"

// The cases. No angle that decides is within a degree of a right one, except in whole numbers.

namespace raylab::grading::local {

inline Vec3d tilted(Dice& dice, const Vec3d& axis, double degrees) {
    const Vec3d aside = glm::normalize(cross(axis, dice.direction()));
    return std::cos(degrees * degree) * axis + std::sin(degrees * degree) * aside;
}

inline Vec3d any_color(Dice& dice) { return dice.point(0.1, 0.9); }

inline LocalSurface any_surface(Dice& dice) {
    const Vec3d normal = dice.direction(), to_viewer = tilted(dice, normal, dice.in(5, 75));
    const Vec3d unlit = 0.3 * any_color(dice), diffuse = any_color(dice);
    return {normal, to_viewer, unlit, diffuse, any_color(dice), whole(dice, 2, 9) + 0.5};
}

/// A light so many degrees from the normal, which falls off.
inline IncidentLight light_at(Dice& dice, const Vec3d& normal, double degrees) {
    const Vec3d way = tilted(dice, normal, degrees) * dice.in(1.2, 4);
    const Vec3d color = any_color(dice) * 2.0;
    return {way, color, dice.point(0.1, 1)};
}

inline double cosine_at_mirror(const LocalSurface& surface, const IncidentLight& light) {
    return seen_light(surface, light).mirrored;
}

/// A light before the surface whose highlight is seen.
inline IncidentLight light_before(Dice& dice, const LocalSurface& surface) {
    for (;;) {
        const IncidentLight light = light_at(dice, surface.normal, dice.in(5, 80));
        if (cosine_at_mirror(surface, light) > 0.3) return light;
    }
}

/// A light behind the surface whose mirror direction is near the viewer: a careless formula sees its highlight.
inline IncidentLight light_behind(Dice& dice, const LocalSurface& surface) {
    for (;;) {
        const IncidentLight light = light_at(dice, surface.normal, dice.in(95, 170));
        if (cosine_at_mirror(surface, light) > 0.1) return light;
    }
}

/// A surface that a viewer sees from low enough for the above.
inline LocalSurface low_surface(Dice& dice) {
    LocalSurface surface = any_surface(dice);
    surface.to_viewer = tilted(dice, surface.normal, dice.in(55, 80));
    return surface;
}

inline Arguments two_lights(Dice& dice) {
    const LocalSurface surface = any_surface(dice);
    const IncidentLight one = light_before(dice, surface);
    return {surface, {one, light_before(dice, surface)}};
}

inline Arguments one_behind(Dice& dice) {
    const LocalSurface surface = low_surface(dice);
    const IncidentLight before = light_before(dice, surface), behind = light_behind(dice, surface);
    if (heads(dice)) return {surface, {before, behind}};
    return {surface, {behind, before}};
}

inline Arguments both_behind(Dice& dice) {
    const LocalSurface surface = low_surface(dice);
    const IncidentLight one = light_behind(dice, surface);
    return {surface, {one, light_behind(dice, surface)}};
}

/// Together with others no brighter than white.
inline void dim(const LocalSurface& surface, IncidentLight& light) {
    light.color *= 0.2 * seen_light(surface, light).falls;
}

/// Near some lights the divisor is less than 1: it may make a dim colour brighter.
inline Arguments one_light(Dice& dice) {
    const LocalSurface surface = any_surface(dice);
    IncidentLight light = light_before(dice, surface);
    if (heads(dice)) light.attenuation *= dice.in(0.02, 0.04);
    dim(surface, light);
    return {surface, {light}};
}

inline Arguments no_light(Dice& dice) { return {any_surface(dice), {}}; }

inline Arguments steady_lights(Dice& dice) {
    Arguments given = two_lights(dice);
    for (IncidentLight& light : given.lights) light.attenuation = {1, 0, 0};
    return given;
}

inline Arguments far_from_mirror(Dice& dice) {
    for (;;) {
        LocalSurface surface = any_surface(dice);
        surface.shininess = whole(dice, 1, 4);
        IncidentLight one = light_at(dice, surface.normal, dice.in(30, 80));
        IncidentLight other = light_at(dice, surface.normal, dice.in(30, 80));
        if (!(cosine_at_mirror(surface, one) < -0.02 && cosine_at_mirror(surface, other) < -0.02)) continue;
        dim(surface, one);
        dim(surface, other);
        return {surface, {one, other}};
    }
}

inline Arguments bright_lights(Dice& dice) {
    Arguments given = two_lights(dice);
    for (IncidentLight& light : given.lights) light.color *= dice.in(8, 30) * seen_light(given.surface, light).falls;
    return given;
}

/// Along an axis looks the normal; the light lies in the plane, exactly opposite the viewer or nearly so.
inline Arguments light_in_plane(Dice& dice) {
    Arguments given = two_lights(dice);
    const int axis = whole(dice, 0, 2);
    given.surface.normal = along(axis, sign(dice));
    const Vec3d way = along(axis + 1, 3 * sign(dice)) + along(axis + 2, 4 * sign(dice));
    given.surface.to_viewer = -way / 5.0;
    given.lights[0].way = way;
    given.lights[1].way = given.surface.normal * double(whole(dice, 1, 4)) + along(axis + 1, 1);
    if (heads(dice)) std::swap(given.lights[0], given.lights[1]);
    return given;
}

inline Arguments on_horizon(Dice& dice) {
    Arguments given = two_lights(dice);
    given.lights[0].way = tilted(dice, given.surface.normal, 90 + dice.in(-1e-13, 1e-13));
    return given;
}

}  // namespace raylab::grading::local
