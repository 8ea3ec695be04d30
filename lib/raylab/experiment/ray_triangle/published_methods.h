#pragma once

#include "raylab/experiment/ray_triangle/badouel.h"
#include "raylab/experiment/ray_triangle/baldwin_weber.h"
#include "raylab/experiment/ray_triangle/moeller_trumbore.h"
#include "raylab/experiment/ray_triangle/plane_and_edges.h"
#include "raylab/experiment/ray_triangle/pluecker.h"
#include "raylab/experiment/ray_triangle/watertight.h"

#include <functional>
#include <string>

namespace raylab {

/// A method as it was published: `prepare` makes of a triangle what `hit` is asked with, together with a ray. They keep
/// their types, so that a loop over many rays contains the method instead of calling it.
template <class Prepare, class Intersect>
struct PublishedMethod {
    std::string name, source;
    Prepare prepare;
    Intersect hit;
};

/// Calls `visit` with each of the seven methods in T, in the chapter's order. All but one take the triangle as it is.
template <Real T, class Visit>
void each_published_method(const Visit& visit) {
    using R = const RayOf<T>&;
    using S = const TriangleOf<T>&;
    const std::identity as_it_is;
    const auto add = [&](const char* name, const char* source, auto prepare, auto hit) {
        visit(PublishedMethod<decltype(prepare), decltype(hit)>{name, source, prepare, hit});
    };
    add("plane and edges", "Glassner (ed.), An Introduction to Ray Tracing, 1989", as_it_is,
        [](R ray, S triangle) { return plane_and_edges(ray, triangle); });
    add("Badouel", "Badouel, Graphics Gems, 1990, pp. 390-393", as_it_is,
        [](R ray, S triangle) { return badouel(ray, triangle); });
    add("Moeller-Trumbore", "Moeller & Trumbore, JGT 2(1), 1997", as_it_is,
        [](R ray, S triangle) { return moeller_trumbore(ray, triangle); });
    add("Pluecker, world", "Jones, Ray Tracing News 13(1), 2000", as_it_is,
        [](R ray, S triangle) { return pluecker_in_world(ray, triangle); });
    add("Pluecker", "Jones, Ray Tracing News 13(1), 2000; moments about the ray's origin", as_it_is,
        [](R ray, S triangle) { return pluecker(ray, triangle); });
    add("watertight", "Woop, Benthin & Wald, JCGT 2(1), 2013, pp. 65-82", as_it_is,
        [](R ray, S triangle) { return watertight(ray, triangle); });
    add(
        "Baldwin-Weber", "Baldwin & Weber, JCGT 5(3), 2016", [](S triangle) { return BaldwinWeber<T>(triangle); },
        [](R ray, const BaldwinWeber<T>& map) { return intersect(ray, map); });
}

}  // namespace raylab
