#include "raylab/experiment/ray_polygon/methods.h"

#include "raylab/experiment/ray_polygon/even_odd.h"
#include "raylab/experiment/ray_polygon/fan.h"
#include "raylab/experiment/ray_polygon/half_planes.h"
#include "raylab/geometry/intersect/intersect.h"

#include <algorithm>

namespace raylab {

namespace {

using Polygons = std::span<const Polygon>;
using Queries = std::span<const PolygonQuery>;
using Results = std::span<std::optional<double>>;

template <Real T, class Intersect>
PolygonMethod prepared(std::string name, std::string source, Intersect intersect) {
    using Ready = std::vector<PolygonIn<T>>;
    return {.name = std::move(name),
            .number = number_name<T>,
            .source = std::move(source),
            .prepare = [](Polygons polygons) -> std::any { return Ready(polygons.begin(), polygons.end()); },
            .answer =
                [intersect](const std::any& state, Polygons, Queries queries, Results results) {
                    const auto& polygons = std::any_cast<const Ready&>(state);
                    for (std::size_t i = 0; i < queries.size(); ++i)
                        results[i] = intersect(in<T>(queries[i].ray), polygons[queries[i].polygon]);
                }};
}

template <Real T>
std::vector<PolygonMethod> methods_in() {
    using R = const RayOf<T>&;
    using P = const PolygonIn<T>&;
    return {
        prepared<T>("half-planes", "Glassner (ed.), An Introduction to Ray Tracing, 1989; convex polygons only",
                    [](R ray, P polygon) { return half_planes(ray, polygon); }),
        prepared<T>("even-odd", "Haines, Graphics Gems IV, 1994, pp. 24-46",
                    [](R ray, P polygon) { return even_odd(ray, polygon); }),
        prepared<T>("fan", "triangles from the first vertex, by Moeller & Trumbore; convex polygons only",
                    [](R ray, P polygon) { return fan(ray, polygon); }),
    };
}

PolygonMethod filtered_exact() {
    return {
        .name = "filtered exact",
        .number = "double + exact",
        .source = "a double filter with a proven bound, exact numbers for what it leaves open",
        .prepare = [](Polygons polygons) -> std::any { return std::vector<Shape>(polygons.begin(), polygons.end()); },
        .answer =
            [](const std::any& state, Polygons, Queries queries, Results results) {
                const auto& shapes = std::any_cast<const std::vector<Shape>&>(state);
                DecisionCounts decisions;
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    const auto hit = intersect(queries[i].ray, shapes[queries[i].polygon], {}, decisions);
                    results[i] = hit ? std::optional(hit->t) : std::nullopt;
                }
            }};
}

}  // namespace

std::vector<PolygonMethod> ray_polygon_methods() {
    std::vector<PolygonMethod> methods = methods_in<float>();
    std::ranges::move(methods_in<double>(), std::back_inserter(methods));
    methods.push_back(filtered_exact());
    return methods;
}

}  // namespace raylab
