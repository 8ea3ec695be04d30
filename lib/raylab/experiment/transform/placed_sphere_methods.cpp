#include "raylab/experiment/transform/placed_sphere_methods.h"

#include "raylab/experiment/transform/placed_sphere.h"
#include "raylab/geometry/intersect/intersect.h"

namespace raylab {

namespace {

// Makes a Method of a Prepared<T> of placed_sphere.h.
template <Real T, class Prepared>
PlacedSphereMethod method(const std::string& name, const std::string& number, const std::string& source) {
    return {.name = name,
            .number = number,
            .source = source,
            .prepare =
                [](std::span<const Affine> maps) { return std::any(std::vector<Prepared>(maps.begin(), maps.end())); },
            .answer =
                [](const std::any& state, std::span<const Affine>, std::span<const PlacedSphereQuery> queries,
                   std::span<std::optional<double>> answers) {
                    const auto& prepared = std::any_cast<const std::vector<Prepared>&>(state);
                    for (std::size_t i = 0; i < queries.size(); ++i)
                        answers[i] = prepared[queries[i].which].hit(in<T>(queries[i].ray));
                }};
}

PlacedSphereMethod filtered_exact() {
    return {.name = "filtered exact",
            .number = "float to exact",
            .source = "the adjugate in enclosures, exact arithmetic where they leave a decision open",
            .prepare = {},
            .answer = [](const std::any&, std::span<const Affine> maps, std::span<const PlacedSphereQuery> queries,
                         std::span<std::optional<double>> answers) {
                const Shape sphere = Sphere{{0, 0, 0}, 1};
                DecisionCounts decisions;
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    const auto hit = intersect(queries[i].ray, sphere, maps[queries[i].which], decisions);
                    answers[i] = hit ? std::optional(hit->t) : std::nullopt;
                }
            }};
}

template <Real T>
void add_all(std::vector<PlacedSphereMethod>& methods, const std::string& number) {
    methods.push_back(method<T, InverseMatrix<T>>("inverse matrix", number, "the 4 x 4 matrix of every textbook"));
    methods.push_back(method<T, InverseAfterMove<T>>("move, then inverse", number, "the same, translation first"));
    methods.push_back(method<T, Adjugate<T>>("adjugate", number, "Cramer's rule without its division"));
    methods.push_back(
        method<T, WorldQuadric<T>>("world quadric", number, "the matrix of the quadric, carried by congruence"));
}

}  // namespace

std::vector<PlacedSphereMethod> placed_sphere_methods() {
    std::vector<PlacedSphereMethod> methods;
    add_all<float>(methods, "float");
    add_all<double>(methods, "double");
    methods.push_back(filtered_exact());
    return methods;
}

PlacedSphereMethod unit_again_method() {
    return method<double, UnitAgain<double>>("direction made unit again", "double", "a frequent mistake");
}

}  // namespace raylab
