#pragma once

#include "arguments.h"
#include "symptom.h"
#include "truth.h"

#include <algorithm>
#include <cmath>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::normals {

inline Vec3d to_vector(std::span<const double> v) { return {v[0], v[1], v[2]}; }

inline double determinant(const Case& question) {
    const auto columns = arguments(question.input).columns;
    return dot(columns[0], cross(columns[1], columns[2]));
}

inline bool is_along(const WrongAnswer& w, const Vec3d& v) {
    const double length = glm::length(v), given = glm::length(to_vector(w.given));
    return length > 0 && given > 0 &&
           std::abs(std::abs(dot(to_vector(w.given), v)) - given * length) <= 1e-7 * given * length;
}

inline bool is_opposite(const WrongAnswer& w) { return dot(to_vector(w.given), to_vector(w.right)) < 0; }

inline bool are_along(const Vec3d& a, const Vec3d& b) {
    const double lengths = glm::length(a) * glm::length(b);
    return std::abs(std::abs(dot(a, b)) - lengths) <= 1e-7 * lengths;
}

/// The normal is carried by another formula. Some maps carry it rightly by that, too: there only the side can be wrong,
/// which says nothing of the formula.
inline Symptom carried_by(const std::string& hint, const std::string& words, Vec3d (*carry)(const Arguments&)) {
    const auto goes_along = [carry](const WrongAnswer& w) { return is_along(w, carry(arguments(w.question.input))); };
    const auto is_another = [carry](const Case& question) {
        const auto given = arguments(question.input);
        return !are_along(carry(given), truth(given));
    };
    return {hint, words, [=](const WrongAnswer& w) { return is_another(w.question) && goes_along(w); }, is_another,
            goes_along};
}

inline Vec3d rows_times(const Arguments& given, const Vec3d& v) {
    const auto& c = given.columns;
    return {dot(c[0], v), dot(c[1], v), dot(c[2], v)};
}

inline Vec3d times_columns(const std::array<Vec3d, 3>& c, const Vec3d& v) {
    return c[0] * v.x + c[1] * v.y + c[2] * v.z;
}

inline std::array<Vec3d, 3> inverse_rows(const Arguments& given) {
    const auto& [x, y, z] = given.columns;
    return {cross(y, z), cross(z, x), cross(x, y)};  // times the determinant
}

/// The 2 x 2 minors of the map, without the signs that make cofactors of them.
inline Vec3d by_minors(const Arguments& given) {
    const auto& c = given.columns;
    Vec3d sum(0);
    for (int row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
            const int r = row == 0 ? 1 : 0, s = row == 2 ? 1 : 2;
            const std::size_t a = column == 0 ? 1 : 0, b = column == 2 ? 1 : 2;
            sum[row] += (c[a][r] * c[b][s] - c[b][r] * c[a][s]) * given.normal[static_cast<int>(column)];
        }
    return sum;
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"helper_axis", "the normal points along an axis, and you give no number", [](const WrongAnswer& w) {
             const auto n = arguments(w.question.input).normal;
             return std::isnan(w.given[0]) && std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) == glm::length(n);
         }});
    add({"compared_with_the_old", "your normal points to the other side, but not away from the one before the map",
         [](const WrongAnswer& w) {
             return is_opposite(w) && is_along(w, to_vector(w.right)) &&
                    dot(to_vector(w.given), arguments(w.question.input).normal) >= 0;
         },
         [](const Case& q) {
             const auto given = arguments(q.input);
             return dot(truth(given), given.normal) < 0;
         }});
    add({"mirror_forgotten", "the map mirrors, and your normal points to the other side",
         [](const WrongAnswer& w) { return is_opposite(w) && is_along(w, to_vector(w.right)); },
         [](const Case& q) { return determinant(q) < 0; }});
    add({"not_normalised", "the direction is right and the length is not", [](const WrongAnswer& w) {
             return !is_opposite(w) && is_along(w, to_vector(w.right)) && !agree(w.given, w.right);
         }});
    for (double least = 1e-6; least > 1e-15; least /= 2)  // whatever somebody takes for none
        add({"small_is_not_singular", "the map shrinks everything a thousand times and more",
             [least](const WrongAnswer& w) { return std::abs(determinant(w.question)) < least; },
             [least](const Case& q) { return std::abs(determinant(q)) < least; }});
    add(carried_by("checkerboard", "your normal is carried by the minors, all with the sign +", by_minors));
    add(carried_by("scales_lost", "your normal is right for columns of length 1", [](const Arguments& g) {
        const auto& c = g.columns;
        const auto rows = inverse_rows({{glm::normalize(c[0]), glm::normalize(c[1]), glm::normalize(c[2])}, g.normal});
        return g.normal.x * rows[0] + g.normal.y * rows[1] + g.normal.z * rows[2];
    }));
    add(carried_by("like_a_point", "your normal is where the map carries it as an arrow",
                   [](const Arguments& g) { return times_columns(g.columns, g.normal); }));
    add(carried_by("transposed_not_inverted", "your normal is the transposed map's",
                   [](const Arguments& g) { return rows_times(g, g.normal); }));
    add(carried_by("inverse_not_transposed", "your normal is the inverse map's", [](const Arguments& g) {
        const auto rows = inverse_rows(g);
        return Vec3d{dot(rows[0], g.normal), dot(rows[1], g.normal), dot(rows[2], g.normal)};
    }));
    add(carried_by("unchanged", "your normal is the one before the map", [](const Arguments& g) { return g.normal; }));
    add(carried_by("scales_only", "each coordinate is divided by the length of its column", [](const Arguments& g) {
        return Vec3d{g.normal.x / glm::length(g.columns[0]), g.normal.y / glm::length(g.columns[1]),
                     g.normal.z / glm::length(g.columns[2])};
    }));
    add(carried_by(
        "scales_only", "your normal is carried by the map, with columns of length 1", [](const Arguments& g) {
            const auto& c = g.columns;
            return times_columns({glm::normalize(c[0]), glm::normalize(c[1]), glm::normalize(c[2])}, g.normal);
        }));
    add(carried_by(
        "scales_only", "your normal is carried by the map, each coordinate divided by its column's square",
        [](const Arguments& g) {
            const auto& c = g.columns;
            return times_columns({c[0] / dot(c[0], c[0]), c[1] / dot(c[1], c[1]), c[2] / dot(c[2], c[2])}, g.normal);
        }));
    add(carried_by("scales_only", "each coordinate is divided by its own axis's entry", [](const Arguments& g) {
        return Vec3d{g.normal.x / g.columns[0].x, g.normal.y / g.columns[1].y, g.normal.z / g.columns[2].z};
    }));
    add({"points_inward", "your normal points to the other side of the surface",
         [](const WrongAnswer& w) { return is_opposite(w) && is_along(w, to_vector(w.right)); }});
    return of_numbers(std::move(all), {"helper_axis"});
}

}  // namespace raylab::grading::normals
