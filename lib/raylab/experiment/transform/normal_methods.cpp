#include "raylab/experiment/transform/normal_methods.h"

#include "raylab/geometry/transformed_normal.h"

#include <gmpxx.h>

#include <string>

namespace raylab {

namespace {

template <Real T>
struct NormalIn {
    std::array<Vec3<T>, 3> columns;
    Vec3<T> normal;
};

template <Real T>
Vec3<T> like_a_point(const NormalIn<T>& q) {
    return glm::normalize(q.columns[0] * q.normal.x + q.columns[1] * q.normal.y + q.columns[2] * q.normal.z);
}

template <Real T>
Vec3<T> by_cofactors(const NormalIn<T>& q) {
    const auto& [x, y, z] = q.columns;
    return cross(y, z) * q.normal.x + cross(z, x) * q.normal.y + cross(x, y) * q.normal.z;
}

template <Real T>
Vec3<T> inverse_transpose(const NormalIn<T>& q) {
    const auto& [x, y, z] = q.columns;
    const T determinant = dot(x, cross(y, z));
    return glm::normalize((cross(y, z) / determinant) * q.normal.x + (cross(z, x) / determinant) * q.normal.y +
                          (cross(x, y) / determinant) * q.normal.z);
}

template <Real T>
Vec3<T> cofactors_without_sign(const NormalIn<T>& q) {
    return glm::normalize(by_cofactors(q));
}

template <Real T>
Vec3<T> cofactors(const NormalIn<T>& q) {
    const auto& [x, y, z] = q.columns;
    const Vec3<T> carried = by_cofactors(q);
    return glm::normalize(dot(x, cross(y, z)) < 0 ? -carried : carried);
}

template <Real T, class Function>
NormalMethod method(const std::string& name, const std::string& number, const std::string& source, Function function) {
    return {
        .name = name,
        .number = number,
        .source = source,
        .prepare = {},
        .answer = [function](const std::any&, std::span<const std::monostate>, std::span<const NormalQuery> queries,
                             std::span<Vec3d> answers) {
            for (std::size_t i = 0; i < queries.size(); ++i) {
                const auto& [x, y, z] = queries[i].columns;
                const NormalIn<T> query{{convert<T>(x), convert<T>(y), convert<T>(z)}, convert<T>(queries[i].normal)};
                answers[i] = convert<double>(function(query));
            }
        }};
}

template <Real T>
void add_all(std::vector<NormalMethod>& methods, const std::string& number) {
    methods.push_back(method<T>("like a point", number, "a frequent mistake", like_a_point<T>));
    methods.push_back(method<T>("inverse transpose", number,
                                "Turkowski, \"Properties of Surface-Normal Transformations\", "
                                "Graphics Gems, 1990",
                                inverse_transpose<T>));
    methods.push_back(method<T>("cofactors, sign forgotten", number, "a frequent mistake", cofactors_without_sign<T>));
    methods.push_back(method<T>("cofactors", number, "the inverse transpose without its division", cofactors<T>));
}

using Exact = Triple<mpq_class>;

Exact exact(const Vec3f& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }

Exact carried(const std::array<Exact, 3>& columns, const Exact& v) {
    return v.x * columns[0] + v.y * columns[1] + v.z * columns[2];
}

// Rounded after a division by the largest coordinate, so that nothing under- or overflows.
Vec3d unit(const Exact& v) {
    mpq_class largest = abs(v.x);
    for (const auto& size : {mpq_class(abs(v.y)), mpq_class(abs(v.z))})
        if (size > largest) largest = size;
    const auto rounded = [&](const mpq_class& c) { return mpq_class(c / largest).get_d(); };
    return glm::normalize(Vec3d{rounded(v.x), rounded(v.y), rounded(v.z)});
}

}  // namespace

std::vector<NormalMethod> normal_methods() {
    std::vector<NormalMethod> methods;
    add_all<float>(methods, "float");
    add_all<double>(methods, "double");
    return methods;
}

NormalMethod your_normal_method() {
    return method<double>("yours", "double", "exercise 04",
                          [](const NormalIn<double>& q) { return transformed_normal(q.columns, q.normal); });
}

Vec3d exact_normal(const NormalQuery& query) {
    const std::array<Exact, 3> columns{exact(query.columns[0]), exact(query.columns[1]), exact(query.columns[2])};
    const Exact n = exact(query.normal);
    const Exact aside = abs(n.x) < abs(n.y) ? Exact{1, 0, 0} : Exact{0, 1, 0};
    const Exact tangent = cross(n, aside);
    const Exact upright = cross(carried(columns, tangent), carried(columns, cross(n, tangent)));
    const bool same_side = dot(upright, carried(columns, n)) > 0;
    return same_side ? unit(upright) : -unit(upright);
}

}  // namespace raylab
