#include "raylab/experiment/ray_quadric/ray_quadric_methods.h"

#include "raylab/experiment/ray_quadric/ray_quadric.h"
#include "raylab/geometry/intersect/intersect.h"
#include "raylab/geometry/oracle/oracle.h"

namespace raylab {

namespace {

using Answers = std::span<std::optional<double>>;

template <Real T>
QuadricMethod general(std::string number) {
    return {
        "general quadric",
        std::move(number),
        "Roth, Ray Casting for Modeling Solids, 1982; chapter 02",
        {},
        [](const std::any&, std::span<const Quadric> quadrics, std::span<const QuadricQuery> queries, Answers answers) {
            for (std::size_t i = 0; i < queries.size(); ++i) {
                const auto hit = nearest_quadric_hit(in<T>(queries[i].ray), quadrics[queries[i].quadric]);
                answers[i] = hit ? std::optional(cast<double>(hit->t)) : std::nullopt;
            }
        }};
}

std::any as_shapes(std::span<const Quadric> quadrics) {
    std::vector<Shape> shapes;
    for (const Quadric& quadric : quadrics) shapes.push_back(as_shape(quadric));
    return shapes;
}

// A method that asks about a scene's shapes, one at a time.
template <class One>
QuadricMethod of_shapes(std::string name, std::string number, std::string source, One one) {
    return {
        std::move(name), std::move(number), std::move(source), as_shapes,
        [one](const std::any& state, std::span<const Quadric>, std::span<const QuadricQuery> queries, Answers answers) {
            const auto& shapes = *std::any_cast<std::vector<Shape>>(&state);
            for (std::size_t i = 0; i < queries.size(); ++i)
                answers[i] = one(queries[i].ray, shapes[queries[i].quadric]);
        }};
}

std::optional<double> filtered_exact(const Ray& ray, const Shape& shape) {
    DecisionCounts decisions;
    const auto hit = intersect(ray, shape, Affine{}, decisions);
    return hit ? std::optional(hit->t) : std::nullopt;
}

std::optional<double> from_oracle(const Ray& ray, const Shape& shape) {
    const auto answer = oracle::intersect(in<double>(ray), shape);
    return answer.hit() ? std::optional(answer.t->nearest()) : std::nullopt;
}

}  // namespace

std::vector<QuadricMethod> ray_quadric_methods() {
    return {general<float>("float"), general<double>("double"), general<long double>("long double"),
            of_shapes("filtered exact", "double + exact", "a double filter with a proven bound", filtered_exact)};
}

QuadricMethod exact_quadric_method() {
    return of_shapes("exact", "algebraic", "CGAL, square roots of rational numbers", from_oracle);
}

Shape as_shape(const Quadric& quadric) {
    return std::visit([](const auto& shape) -> Shape { return shape; }, quadric);
}

}  // namespace raylab
