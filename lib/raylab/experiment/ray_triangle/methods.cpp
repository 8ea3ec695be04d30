#include "raylab/experiment/ray_triangle/methods.h"

#include "raylab/experiment/ray_triangle/badouel.h"
#include "raylab/experiment/ray_triangle/baldwin_weber.h"
#include "raylab/experiment/ray_triangle/moeller_trumbore.h"
#include "raylab/experiment/ray_triangle/plane_and_edges.h"
#include "raylab/experiment/ray_triangle/pluecker.h"
#include "raylab/experiment/ray_triangle/watertight.h"
#include "raylab/geometry/intersect/intersect.h"
#include "raylab/geometry/oracle/oracle.h"

#include <algorithm>
#include <cassert>

namespace raylab {

namespace {

template <Real T>
std::optional<TriangleHit> in_double(const std::optional<TriangleHitOf<T>>& hit) {
    if (!hit) return std::nullopt;
    return TriangleHit{cast<double>(hit->t), cast<double>(hit->u), cast<double>(hit->v)};
}

using Triangles = std::span<const Triangle>;
using Queries = std::span<const TriangleQuery>;
using Results = std::span<std::optional<TriangleHit>>;

/// A method that prepares nothing: `intersect` answers one ray and one triangle in T.
template <Real T, class Intersect>
TriangleMethod unprepared(std::string name, std::string source, Intersect intersect) {
    return {.name = std::move(name),
            .number = number_name<T>,
            .source = std::move(source),
            .prepare = {},
            .answer = [intersect](const std::any&, Triangles triangles, Queries queries, Results results) {
                for (std::size_t i = 0; i < queries.size(); ++i)
                    results[i] = in_double(intersect(in<T>(queries[i].ray), in<T>(triangles[queries[i].triangle])));
            }};
}

template <Real T>
TriangleMethod baldwin_weber() {
    using Maps = std::vector<BaldwinWeber<T>>;
    return {.name = "Baldwin-Weber",
            .number = number_name<T>,
            .source = "Baldwin & Weber, JCGT 5(3), 2016",
            .prepare = [](Triangles triangles) -> std::any {
                Maps maps;
                maps.reserve(triangles.size());
                for (const auto& triangle : triangles) maps.emplace_back(in<T>(triangle));
                return maps;
            },
            .answer =
                [](const std::any& state, Triangles, Queries queries, Results results) {
                    const auto& maps = std::any_cast<const Maps&>(state);
                    for (std::size_t i = 0; i < queries.size(); ++i)
                        results[i] = in_double(intersect(in<T>(queries[i].ray), maps[queries[i].triangle]));
                }};
}

template <Real T>
TriangleMethod moeller_trumbore_with(T smallest_determinant, const std::string& epsilon) {
    return unprepared<T>("Moeller-Trumbore, eps " + epsilon, "Moeller & Trumbore, JGT 2(1), 1997, with its epsilon",
                         [smallest_determinant](const RayOf<T>& ray, const TriangleOf<T>& triangle) {
                             return moeller_trumbore(ray, triangle, smallest_determinant);
                         });
}

template <Real T>
std::vector<TriangleMethod> methods_in() {
    using R = const RayOf<T>&;
    using S = const TriangleOf<T>&;
    return {
        unprepared<T>("plane and edges", "Glassner (ed.), An Introduction to Ray Tracing, 1989",
                      [](R ray, S triangle) { return plane_and_edges(ray, triangle); }),
        unprepared<T>("Badouel", "Badouel, Graphics Gems, 1990, pp. 390-393",
                      [](R ray, S triangle) { return badouel(ray, triangle); }),
        unprepared<T>("Moeller-Trumbore", "Moeller & Trumbore, JGT 2(1), 1997",
                      [](R ray, S triangle) { return moeller_trumbore(ray, triangle); }),
        unprepared<T>("Pluecker, world", "Jones, Ray Tracing News 13(1), 2000",
                      [](R ray, S triangle) { return pluecker_in_world(ray, triangle); }),
        unprepared<T>("Pluecker", "Jones, Ray Tracing News 13(1), 2000; moments about the ray's origin",
                      [](R ray, S triangle) { return pluecker(ray, triangle); }),
        unprepared<T>("watertight", "Woop, Benthin & Wald, JCGT 2(1), 2013, pp. 65-82",
                      [](R ray, S triangle) { return watertight(ray, triangle); }),
        baldwin_weber<T>(),
    };
}

TriangleMethod filtered_exact() {
    return {.name = "filtered exact",
            .number = "double + exact",
            .source = "Shewchuk, Discrete & Computational Geometry 18, 1997, pp. 305-363",
            .prepare = {},
            .answer = [](const std::any&, Triangles triangles, Queries queries, Results results) {
                DecisionCounts decisions;
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    const auto hit = intersect(queries[i].ray, triangles[queries[i].triangle], decisions);
                    results[i] = hit ? std::optional(TriangleHit{hit->t, hit->u, hit->v}) : std::nullopt;
                }
            }};
}

}  // namespace

std::vector<TriangleMethod> ray_triangle_methods() {
    std::vector<TriangleMethod> methods = methods_in<float>();
    std::ranges::move(methods_in<double>(), std::back_inserter(methods));
    methods.push_back(moeller_trumbore_with(1e-8f, "1e-8"));
    methods.push_back(moeller_trumbore_with(1e-5f, "1e-5"));
    methods.push_back(moeller_trumbore_with(1e-8, "1e-8"));
    methods.push_back(filtered_exact());
    return methods;
}

TriangleMethod exact_triangle_method() {
    return {.name = "exact",
            .number = "rational",
            .source = "CGAL, exact kernel with exact constructions",
            .prepare = {},
            .answer = [](const std::any&, Triangles triangles, Queries queries, Results results) {
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    const auto triangle = in<double>(triangles[queries[i].triangle]);
                    const auto answer = oracle::intersect(in<double>(queries[i].ray), triangle);
                    results[i] = answer.hit() ? std::optional(TriangleHit{answer.t->nearest(), 0, 0}) : std::nullopt;
                }
            }};
}

TriangleMethod your_triangle_method() { return unprepared<double>("yours", "the slot of exercise 03", triangle_hit); }

}  // namespace raylab
