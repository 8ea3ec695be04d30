#include "raylab/experiment/ray_sphere/ray_sphere_methods.h"

#include "raylab/experiment/ray_sphere/ray_sphere.h"
#include "raylab/geometry/intersect/intersect.h"
#include "raylab/geometry/nearest_sphere_hit.h"
#include "raylab/geometry/oracle/oracle.h"
#include "raylab/geometry/quadric.h"

namespace raylab {

namespace {

using One = std::optional<double> (*)(const SphereQuery&);

// A method out of one answer. The answer is a template argument, so that only the batch pays an indirect call.
template <One one>
SphereMethod method(std::string name, std::string number, std::string source) {
    return {std::move(name),
            std::move(number),
            std::move(source),
            {},
            [](const std::any&, std::span<const std::monostate>, std::span<const SphereQuery> queries,
               std::span<std::optional<double>> answers) {
                for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = one(queries[i]);
            }};
}

template <Real T, std::optional<T> (*hit)(const RayOf<T>&, const SphereOf<T>&)>
std::optional<double> computed_in(const SphereQuery& query) {
    const std::optional<T> t = hit(in<T>(query.ray), in<T>(query.sphere));
    return t ? std::optional(cast<double>(*t)) : std::nullopt;
}

std::optional<double> filtered_exact(const SphereQuery& query) {
    DecisionCounts decisions;
    const auto hit = intersect(query.ray, query.sphere, decisions);
    return hit ? std::optional(hit->t) : std::nullopt;
}

std::optional<double> from_oracle(const SphereQuery& query) {
    const auto answer = oracle::intersect(in<double>(query.ray), in<double>(query.sphere));
    return answer.hit() ? std::optional(answer.t->nearest()) : std::nullopt;
}

const char* const school = "the school formula";
const char* const press = "Press, Teukolsky, Vetterling, Flannery: Numerical Recipes, section 5.6";
const char* const haines = "Haines, Guenther, Akenine-Moeller: Ray Tracing Gems, 2019, chapter 7";
const char* const pharr = "Pharr, Jakob, Humphreys: Physically Based Rendering, 4th edition, section 6.8";

template <Real T>
void add_all_in(std::vector<SphereMethod>& methods, const std::string& number) {
    methods.push_back(method<computed_in<T, textbook_sphere_hit<T>>>("textbook", number, school));
    methods.push_back(method<computed_in<T, stable_sphere_hit<T>>>("stable", number, press));
    methods.push_back(method<computed_in<T, reformulated_sphere_hit<T>>>("reformulated", number, haines));
    methods.push_back(method<computed_in<T, factored_sphere_hit<T>>>("factored", number, pharr));
}

}  // namespace

std::vector<SphereMethod> ray_sphere_methods() {
    std::vector<SphereMethod> methods;
    add_all_in<float>(methods, "float");
    add_all_in<double>(methods, "double");
    methods.push_back(method<computed_in<long double, stable_sphere_hit<long double>>>("stable", "long double", press));
    methods.push_back(
        method<filtered_exact>("filtered exact", "double + exact", "a double filter with a proven bound"));
    return methods;
}

SphereMethod exact_sphere_method() {
    return method<from_oracle>("exact", "algebraic", "CGAL, square roots of rational numbers");
}

SphereMethod your_sphere_method() {
    return method<computed_in<double, nearest_sphere_hit>>("yours", "double", "nearest_sphere_hit(), exercise 02");
}

}  // namespace raylab
