#include "raylab/experiment/refraction_methods.h"

#include "raylab/tracer/refracted_direction.h"

#include <gmpxx.h>

#include <cmath>

namespace raylab {

namespace {

// The arguments of a method: unit vectors, as good as T makes them, and the ratio of the indices.
template <Real T>
struct Arriving {
    Vec3<T> direction, normal;
    T eta, cosine;
};

template <Real T>
Arriving<T> arriving(const RefractionQuery& query) {
    const auto direction = glm::normalize(convert<T>(query.direction)),
               normal = glm::normalize(convert<T>(query.normal));
    return {direction, normal, T{query.ior_before} / T{query.ior_behind}, -dot(direction, normal)};
}

template <Real T>
using Refracted = std::optional<Vec3<T>>;

// The angles themselves, and a vector along the surface to turn towards.
template <Real T>
Refracted<T> by_angles(const Arriving<T>& a) {
    const T sine = a.eta * std::sin(std::acos(std::min(a.cosine, T(1))));
    if (sine > 1) return std::nullopt;
    const T angle = std::asin(sine);
    const Vec3<T> along = a.direction + a.cosine * a.normal;
    if (!(dot(along, along) > 0)) return -a.normal;
    return std::sin(angle) * glm::normalize(along) - std::cos(angle) * a.normal;
}

// Behind the surface the cosine's square is given: what is left is one line.
template <Real T>
Refracted<T> with_square(const Arriving<T>& a, T square) {
    if (square < 0) return std::nullopt;
    return a.eta * a.direction + (a.eta * a.cosine - std::sqrt(square)) * a.normal;
}

template <Real T>
Refracted<T> heckbert(const Arriving<T>& a) {
    return with_square(a, 1 - a.eta * a.eta * (1 - a.cosine * a.cosine));
}

template <Real T>
Refracted<T> factored(const Arriving<T>& a) {
    const T squared = a.eta * a.eta;
    return with_square(a, 1 - squared + squared * a.cosine * a.cosine);
}

template <Real T>
Refracted<T> along_the_surface(const Arriving<T>& a) {
    const Vec3<T> along = a.eta * (a.direction + a.cosine * a.normal);
    const T square = 1 - dot(along, along);
    if (!(square >= 0)) return std::nullopt;
    return along - std::sqrt(square) * a.normal;
}

template <Real T, class Function>
RefractionMethod method(const std::string& name, const std::string& source, Function function) {
    return {.name = name,
            .number = number_name<T>,
            .source = source,
            .prepare = {},
            .answer = [function](const std::any&, std::span<const std::monostate>,
                                 std::span<const RefractionQuery> queries, std::span<std::optional<Vec3d>> answers) {
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    const Refracted<T> direction = function(arriving<T>(queries[i]), queries[i]);
                    answers[i] = direction ? std::optional(convert<double>(*direction)) : std::nullopt;
                }
            }};
}

template <Real T>
void add_all(std::vector<RefractionMethod>& methods) {
    const auto add = [&](const std::string& name, const std::string& source,
                         Refracted<T> (*function)(const Arriving<T>&)) {
        methods.push_back(
            method<T>(name, source, [function](const Arriving<T>& a, const RefractionQuery&) { return function(a); }));
    };
    add("angles", "Snell's law, as it is written", by_angles<T>);
    add("root", "Heckbert, \"Writing a Ray Tracer\", An Introduction to Ray Tracing, 1989", heckbert<T>);
    add("root, factored", "the same, multiplied out", factored<T>);
    add("along the surface", "Whitted, CACM 23(6), 1980, with the normal's length kept at 1", along_the_surface<T>);
}

constexpr mp_bitcnt_t bits = 256;

using Exact = Triple<mpq_class>;
using Fine = Triple<mpf_class>;

Exact exact(const Vec3f& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }
mpf_class fine(const mpq_class& x) { return mpf_class(x, bits); }
Fine fine(const Exact& v) { return {fine(v.x), fine(v.y), fine(v.z)}; }
mpf_class root(const mpq_class& x) { return sqrt(fine(x)); }

}  // namespace

std::vector<RefractionMethod> refraction_methods() {
    std::vector<RefractionMethod> methods;
    add_all<float>(methods);
    add_all<double>(methods);
    return methods;
}

RefractionMethod your_refraction_method() {
    return method<double>("yours", "exercise 07", [](const Arriving<double>& a, const RefractionQuery& query) {
        return refracted_direction(a.direction, a.normal, query.ior_before, query.ior_behind);
    });
}

std::optional<Vec3d> exact_refraction(const RefractionQuery& query) {
    const Exact d = exact(query.direction), n = exact(query.normal);
    const Exact across = cross(d, n);  // |d| |n| sin long
    const mpq_class eta = mpq_class(query.ior_before) / mpq_class(query.ior_behind);
    const mpq_class lengths = dot(d, d) * dot(n, n);
    const mpq_class sine_squared = eta * eta * dot(across, across) / lengths;  // behind the surface
    if (sine_squared > 1) return std::nullopt;
    const mpf_class of_normal = root(1 - sine_squared) / root(dot(n, n));
    const mpf_class of_along = fine(eta) / (root(lengths) * root(dot(n, n)));
    const Fine along = fine(cross(n, across)), normal = fine(n);  // n x (d x n) = d (n.n) - n (d.n)
    const Fine refracted = of_along * along - of_normal * normal;
    return Vec3d{refracted.x.get_d(), refracted.y.get_d(), refracted.z.get_d()};
}

}  // namespace raylab
