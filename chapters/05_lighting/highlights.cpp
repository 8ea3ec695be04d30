#include "highlights.h"

#include "raylab/sampling/sequence.h"
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

namespace raylab::lighting {

namespace {

template <Real T>
struct HighlightIn {
    Vec3<T> normal, to_light, to_viewer;
    T shininess;
};

template <Real T>
T mirror_light(const HighlightIn<T>& q) {
    const T incline = dot(q.normal, q.to_light);
    if (!(incline > 0)) return 0;
    const T along = dot(T(2) * incline * q.normal - q.to_light, q.to_viewer);
    return along > 0 ? std::pow(along, q.shininess) : 0;
}

template <Real T>
T mirror_viewer(const HighlightIn<T>& q) {
    if (!(dot(q.normal, q.to_light) > 0)) return 0;
    const T along = dot(T(2) * dot(q.normal, q.to_viewer) * q.normal - q.to_viewer, q.to_light);
    return along > 0 ? std::pow(along, q.shininess) : 0;
}

template <Real T>
T half_vector(const HighlightIn<T>& q, T shininess) {
    if (!(dot(q.normal, q.to_light) > 0)) return 0;
    const T cosine = dot(q.normal, glm::normalize(q.to_light + q.to_viewer));
    return cosine > 0 ? std::pow(cosine, shininess) : 0;
}

template <Real T>
T half_vector_plain(const HighlightIn<T>& q) {
    return half_vector(q, q.shininess);
}

template <Real T>
T half_vector_fourfold(const HighlightIn<T>& q) {
    return half_vector(q, T(4) * q.shininess);
}

template <Real T>
T schlick(const HighlightIn<T>& q) {
    const T incline = dot(q.normal, q.to_light);
    if (!(incline > 0)) return 0;
    const T along = dot(T(2) * incline * q.normal - q.to_light, q.to_viewer);
    return along > 0 ? along / (q.shininess - q.shininess * along + along) : 0;
}

template <Real T>
HighlightMethod method(const std::string& name, const std::string& number, const std::string& source,
                       T (*highlight)(const HighlightIn<T>&)) {
    return {.name = name,
            .number = number,
            .source = source,
            .prepare = {},
            .answer = [highlight](const std::any&, std::span<const std::monostate>,
                                  std::span<const HighlightQuery> queries, std::span<double> answers) {
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    const auto& q = queries[i];
                    answers[i] = highlight(
                        {convert<T>(q.normal), convert<T>(q.to_light), convert<T>(q.to_viewer), cast<T>(q.shininess)});
                }
            }};
}

template <Real T>
void add_all(std::vector<HighlightMethod>& methods, const std::string& number) {
    methods.push_back(method<T>("mirror the light", number, "Bui Tuong Phong, CACM 18(6), 1975", mirror_light));
    methods.push_back(method<T>("mirror the viewer", number, "the same by symmetry", mirror_viewer));
    methods.push_back(
        method<T>("half vector, n", number, "J. Blinn, Models of Light Reflection, SIGGRAPH 1977", half_vector_plain));
    methods.push_back(
        method<T>("half vector, 4n", number, "the same, with the exponent that matches Phong's", half_vector_fourfold));
    methods.push_back(method<T>("quotient", number,
                                "C. Schlick, A Fast Alternative to Phong's Specular Model, Graphics Gems IV, 1994",
                                schlick));
}

// The query is made in a frame that is rotated at random, so that no coordinate is special.
HighlightQuery query(RandomSequence& random, double widest, double shininess) {
    const Vec3d normal = random.unit_vector(), across = random.unit_vector_across(normal);
    const double incline = random.between(0.05, 1.45);
    const Vec3d to_light = std::cos(incline) * normal + std::sin(incline) * across;
    const Vec3d mirrored = 2 * dot(normal, to_light) * normal - to_light;
    const double off = random.between(0, widest);
    const Vec3d to_viewer = std::cos(off) * mirrored + std::sin(off) * random.unit_vector_across(mirrored);
    return {normal, to_light, to_viewer, shininess};
}

HighlightWorkload workload(const std::string& name, const std::string& about, std::size_t points, std::uint64_t seed,
                           double widest, double shininess) {
    HighlightWorkload result{.name = name, .about = about, .data = {}};
    for (std::size_t i = 0; i < points; ++i) {
        RandomSequence random(seed, i);
        result.queries.push_back(query(random, widest, shininess));
    }
    return result;
}

}  // namespace

std::vector<HighlightMethod> highlight_methods() {
    std::vector<HighlightMethod> methods;
    add_all<float>(methods, "float");
    add_all<double>(methods, "double");
    return methods;
}

HighlightMethod your_highlight_method() {
    return {.name = "yours",
            .number = "double",
            .source = "your answer to exercise 05",
            .prepare = {},
            .answer = [](const std::any&, std::span<const std::monostate>, std::span<const HighlightQuery> queries,
                         std::span<double> answers) {
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    const auto& q = queries[i];
                    answers[i] = phong_specular(q.normal, q.to_light, q.to_viewer, q.shininess);
                }
            }};
}

std::vector<HighlightWorkload> highlight_workloads(std::size_t points, std::uint64_t seed) {
    return {workload("bvh8", "shininess 10, viewers up to 2 radians off the mirror direction", points, seed, 2, 10),
            workload("narrow", "shininess 1000, viewers within 0.1 radians", points, seed + 1, 0.1, 1000),
            workload("nearly a mirror", "shininess 1e6, viewers within 0.003 radians: a float's cosine is 1", points,
                     seed + 2, 3e-3, 1e6)};
}

double true_highlight(const HighlightQuery& query) {
    using Wide = long double;
    const auto n = glm::normalize(convert<Wide>(query.normal)), l = glm::normalize(convert<Wide>(query.to_light)),
               v = glm::normalize(convert<Wide>(query.to_viewer));
    const Wide incline = dot(n, l);
    if (!(incline > 0)) return 0;
    const auto mirrored = Wide(2) * incline * n - l;
    const Wide angle = std::atan2(glm::length(cross(mirrored, v)), dot(mirrored, v));
    return std::cos(angle) > 0 ? static_cast<double>(std::pow(std::cos(angle), Wide(query.shininess))) : 0;
}

}  // namespace raylab::lighting
