#pragma once

#include "symptoms_of_sides.h"

#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::mesh_hit {

inline Vec3d asked_normal(const WrongAnswer& w, std::size_t i) {
    return {w.given[3 + 3 * i], w.given[4 + 3 * i], w.given[5 + 3 * i]};
}
inline bool asks_for_no_unit_normal(const WrongAnswer& w) {
    for (std::size_t i = 0; i < std::min<std::size_t>(most_asked, static_cast<std::size_t>(w.given[2])); ++i)
        // No number is another mistake, which is told as that.
        if (std::abs(glm::length(asked_normal(w, i)) - 1) >= 1e-6) return true;
    return false;
}

inline Vec3d along_great_circle(const Vec3d& a, const Vec3d& b, double t) {
    const double angle = std::acos(std::clamp(dot(a, b), -1.0, 1.0));
    if (angle < 1e-12) return a;
    return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

inline Vec3d unit_or_zero(const Vec3d& v) {
    const double length = glm::length(v);
    return length > 1e-12 ? v / length : Vec3d(0);
}
/// From the first vertex of three towards the second, made unit, and from there to the third.
inline Vec3d unit_in_between(const Ingredients& made, const std::array<std::size_t, 3>& order) {
    const auto& [a, b, c] = order;
    const double both = made.weights[a] + made.weights[b];
    const Vec3d first = made.weights[a] * made.normals[a] + made.weights[b] * made.normals[b];
    return both * unit_or_zero(first) + made.weights[c] * made.normals[c];
}

inline void add_weights(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, const Other& other) {
        add_instead(all, hint, words, other);
    };
    for (const auto& order :
         {std::array<std::size_t, 3>{1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {0, 1, 1}, {0, 2, 2}})
        add("weights", "the weights belong to other vertices", [order](const Arguments& given) {
            Ingredients made = ingredients(given.hit);
            const auto w = made.weights;
            made.weights = {w[order[0]], w[order[1]], w[order[2]]};
            return shaded(given.model, made);
        });
    add("rest", "the first vertex counts in full", made_of([](Ingredients& made) { made.weights[0] = 1; }));
    add("weights_forgotten", "all vertices have the same weight", made_of([](Ingredients& made) {
            made.weights = {1.0 / 3, 1.0 / 3, 1.0 / 3};
        }));
    add("weights_forgotten", "the vertices are added up, without weights", made_of([](Ingredients& made) {
            made.weights = {1, 1, 1};
        }));
    add("lerp_twice", "the first two vertices are mixed by u, and that with the third by v",
        made_of([](Ingredients& made) {
            const double u = made.weights[1], v = made.weights[2];
            made.weights = {(1 - u) * (1 - v), u * (1 - v), v};
        }));
    add("lerp_twice", "the first and the third vertex are mixed by v, and that with the second by u",
        made_of([](Ingredients& made) {
            const double u = made.weights[1], v = made.weights[2];
            made.weights = {(1 - v) * (1 - u), u, v * (1 - u)};
        }));
    add("nearest_vertex", "the heaviest vertex counts alone", made_of([](Ingredients& made) {
            const auto most = std::ranges::max_element(made.weights);
            for (double& weight : made.weights) weight = &weight == &*most ? 1 : 0;
        }));
    for (const std::size_t missing : {0u, 1u, 2u})
        add("vertex_missing", "one of the vertices does not count", [missing](const Arguments& given) {
            Ingredients made = ingredients(given.hit);
            made.weights[missing] = 0;
            return shaded(given.model, made);
        });
}

inline void add_mixing(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, const Other& other) {
        add_instead(all, hint, words, other);
    };
    all.push_back(instead("cancel_phong_alone", "where the normals cancel Gouraud's number is the triangle's own, too",
                          [](const Arguments& given) {
                              auto found = truth(given);
                              if (cancels(given.hit)) found.gouraud = given.model(ingredients(given.hit).face);
                              return found;
                          }));
    add("same_twice", "both numbers are Gouraud's", [](const Arguments& given) {
        const double gouraud = truth(given).gouraud;
        return InterpolatedBrightness{gouraud, gouraud};
    });
    add("same_twice", "both numbers are Phong's", [](const Arguments& given) {
        const double phong = truth(given).phong;
        return InterpolatedBrightness{phong, phong};
    });
    add("exchanged", "the two numbers have changed places", [](const Arguments& given) {
        const auto [gouraud, phong] = truth(given);
        return InterpolatedBrightness{phong, gouraud};
    });
    const auto own = [](const Arguments& given, double side) { return given.model(side * given.hit.face); };
    add("flat", "the triangle's own normal is taken", [own](const Arguments& given) {
        const double flat = own(given, side_of(given.hit));
        return InterpolatedBrightness{flat, flat};
    });
    add("flat", "the triangle's own normal is taken", [own](const Arguments& given) {
        const double flat = own(given, 1);
        return InterpolatedBrightness{flat, flat};
    });
    for (const auto& [a, b, c] : {std::array<std::size_t, 3>{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}) {
        const auto mixed_by_turns = [a = a, b = b, c = c](const Arguments& given) {
            const auto [weights, normals, face] = ingredients(given.hit);
            auto found = truth(given);
            const double both = weights[a] + weights[b];
            if (both > 0 && !cancels(given.hit))
                found.phong = given.model(along_great_circle(
                    along_great_circle(normals[a], normals[b], weights[b] / both), normals[c], weights[c]));
            return found;
        };
        all.push_back(instead("unit_in_between", "two normals are mixed, made unit, and then mixed with the third",
                              [order = std::array{a, b, c}](const Arguments& given) {
                                  auto found = truth(given);
                                  const Vec3d normal = unit_or_zero(unit_in_between(ingredients(given.hit), order));
                                  if (normal != Vec3d(0)) found.phong = given.model(normal);
                                  return found;
                              }));
        all.push_back(instead("great_circle", "the normal is mixed along great circles", mixed_by_turns));
        // Between opposite normals there are many, and none that all formulas take.
        all.back().allows = [](const WrongAnswer& w) {
            return glm::length(mixed(ingredients(of(w.question).hit))) < 0.1;
        };
    }
    add("clamped", "what is brighter than 1 is cut off", [](const Arguments& given) {
        const auto [gouraud, phong] = truth(given);
        return InterpolatedBrightness{std::min(1.0, gouraud), std::min(1.0, phong)};
    });
    add("clamped", "what is brighter than 1 at a vertex is cut off", [](const Arguments& given) {
        Model most = given.model;
        const auto made = ingredients(given.hit);
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += made.weights[i] * std::min(1.0, most(made.normals[i]));
        return InterpolatedBrightness{sum, std::min(1.0, truth(given).phong)};
    });
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto is_zero = [](const Case& question) { return cancels(of(question).hit); };
    all.push_back({"cancel", "the mixed normal is zero, and you give no number",
                   [](const WrongAnswer& w) { return !std::isfinite(w.given[1]); }, is_zero});
    add_mixing(all);
    add_weights(all);
    add_sides(all);
    all.push_back({"cancel_side",
                   "the mixed normal is zero, and the triangle's own is not turned to the side that is seen",
                   [](const WrongAnswer& w) {
                       const auto given = of(w.question);
                       return cancels(given.hit) && agree(w.given[1], given.model(given.hit.face));
                   }});
    all.push_back({"cancel", "the mixed normal is zero, and you take another than the triangle's",
                   [](const WrongAnswer& w) { return cancels(of(w.question).hit); }, is_zero});
    all.push_back({"cancel_too_early", "the mixed normal is short and not zero, and you take the triangle's own",
                   [](const WrongAnswer& w) {
                       const auto given = of(w.question);
                       return glm::length(mixed(ingredients(given.hit))) < 0.1 && agree(w.given[0], w.right[0]) &&
                              agree(w.given[1], given.model(side_of(given.hit) * given.hit.face));
                   }});
    all.push_back(
        {"not_unit", "the model is asked for the brightness of a normal that is not unit", asks_for_no_unit_normal});
    return of_numbers(std::move(all), {"cancel"});
}

}  // namespace raylab::grading::mesh_hit
