#include "raylab/experiment/ray_triangle/methods.h"

#include "raylab/experiment/ray_triangle/published_methods.h"
#include "raylab/geometry/intersect/intersect.h"
#include "raylab/geometry/oracle/oracle.h"

#include <any>
#include <type_traits>

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

/// A method that prepares all triangles before the first query.
template <Real T, class Prepare, class Intersect>
TriangleMethod prepared(std::string name, std::string source, Prepare prepare, Intersect intersect) {
    using Prepared = std::vector<std::invoke_result_t<Prepare, TriangleOf<T>>>;
    return {.name = std::move(name),
            .number = number_name<T>,
            .source = std::move(source),
            .prepare = [prepare](Triangles triangles) -> std::any {
                Prepared all;
                all.reserve(triangles.size());
                for (const auto& triangle : triangles) all.push_back(prepare(in<T>(triangle)));
                return all;
            },
            .answer =
                [intersect](const std::any& state, Triangles, Queries queries, Results results) {
                    const auto& all = std::any_cast<const Prepared&>(state);
                    for (std::size_t i = 0; i < queries.size(); ++i)
                        results[i] = in_double(intersect(in<T>(queries[i].ray), all[queries[i].triangle]));
                }};
}

template <Real T>
struct AsTriangleMethod {
    template <class Intersect>
    TriangleMethod operator()(const PublishedMethod<std::identity, Intersect>& method) const {
        return unprepared<T>(method.name, method.source, method.hit);
    }
    template <class Prepare, class Intersect>
    TriangleMethod operator()(const PublishedMethod<Prepare, Intersect>& method) const {
        return prepared<T>(method.name, method.source, method.prepare, method.hit);
    }
};

template <Real T>
TriangleMethod moeller_trumbore_with(T smallest_determinant, const std::string& epsilon) {
    return unprepared<T>("Moeller-Trumbore, eps " + epsilon, "Moeller & Trumbore, JGT 2(1), 1997, with its epsilon",
                         [smallest_determinant](const RayOf<T>& ray, const TriangleOf<T>& triangle) {
                             return moeller_trumbore(ray, triangle, smallest_determinant);
                         });
}

template <Real T>
void add_published(std::vector<TriangleMethod>& methods) {
    each_published_method<T>([&](const auto& method) { methods.push_back(AsTriangleMethod<T>{}(method)); });
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
    std::vector<TriangleMethod> methods;
    add_published<float>(methods);
    add_published<double>(methods);
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
