#pragma once

#include "symptom.h"
#include "truth.h"

#include "raylab/geometry/scaled_to_largest_one.h"

#include <algorithm>
#include <cmath>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::shadow {

inline Arguments of(const Case& question) { return arguments(question.input); }
inline double distance_of(const Case& question) { return glm::length(of(question).light - of(question).point); }

inline bool says_dark(const WrongAnswer& w) { return w.given[0] == 1 && w.right[0] == 0; }
inline bool says_lit(const WrongAnswer& w) { return w.given[0] == 0 && w.right[0] == 1; }
inline bool lit(const Case& question) { return !is_dark(of(question)); }
/// The point lies below its surface: a ray that starts there hits it.
inline bool is_below(const Case& question) { return of(question).above > 0; }

/// How far along the way to the light a sphere that blocks it begins, as a share; 2 where none does.
inline double first_block(const Case& question) {
    const auto given = of(question);
    double first = 2;
    for (const auto& sphere : given.spheres)
        if (sphere.radius > 0)
            if (const auto t = nearest_sphere_hit({given.point, given.light - given.point, {0, 1}}, sphere))
                first = std::min(first, *t);
    return first;
}

/// Whether a sphere lies on the line beyond the light, or behind the point.
inline bool is_beyond(const Case& question) {
    const auto given = of(question);
    return std::ranges::any_of(given.spheres, [&](const auto& sphere) {
        return sphere.radius > 0 && nearest_sphere_hit({given.point, given.light - given.point, {1, 1e9}}, sphere);
    });
}
inline bool is_behind_point(const Case& question) {
    const auto given = of(question);
    return std::ranges::any_of(given.spheres, [&](const auto& sphere) {
        return sphere.radius > 0 && nearest_sphere_hit({given.point, given.point - given.light, {0, 1e9}}, sphere);
    });
}
/// The light's place, taken for the way to it, leads behind the surface.
inline bool is_place_behind(const Case& question) { return dot(of(question).normal, of(question).light) <= 0; }
inline double size_of(const Case& question) {
    return std::max(largest_coordinate(of(question).point), largest_coordinate(of(question).light));
}
inline bool is_low(const Case& question) {
    const auto given = of(question);
    return dot(given.normal, given.light - given.point) < 0.05 * distance_of(question);
}
/// The rounding is as large as in no scene of some metres.
inline bool is_large(const Case& question) { return size_of(question) > 1e3; }
/// What is in the way is less than a thousandth off: of a metre, or of the largest coordinate.
inline bool is_close(const Case& question) {
    return first_block(question) * distance_of(question) < 1e-3 * std::max(1.0, size_of(question));
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"light_behind", "the light is behind the surface, and you say lit",
         [](const WrongAnswer& w) { return says_lit(w) && is_behind(of(w.question)); },
         [](const Case& q) { return is_behind(of(q)) && first_block(q) > 1; }});
    add({"light_is_a_place", "which side the light is on is told by the light's own coordinates",
         [](const WrongAnswer& w) { return says_dark(w) && is_place_behind(w.question); },
         [](const Case& q) { return lit(q) && is_place_behind(q); }});
    add({"rises_too_little", "the light stands low over the surface, nothing is in its way, and you say in shadow",
         [](const WrongAnswer& w) { return says_dark(w) && is_low(w.question) && is_below(w.question); }});
    add({"too_near", "the coordinates are large, the point lies a hair under its surface, and you say in shadow",
         [](const WrongAnswer& w) { return says_dark(w) && is_below(w.question) && is_large(w.question); }});
    add({"starts_on_surface", "the point lies a hair under its surface, nothing is in the way, and you say in shadow",
         [](const WrongAnswer& w) { return says_dark(w) && is_below(w.question) && !is_beyond(w.question); },
         [](const Case& q) { return lit(q) && is_below(q) && !is_beyond(q); }});
    add({"starts_on_surface",
         "the point lies a hair under its surface, something stands behind the first hit, and you say lit",
         [](const WrongAnswer& w) { return says_lit(w) && is_below(w.question) && !is_behind(of(w.question)); },
         [](const Case& q) { return is_below(q) && !is_behind(of(q)) && !lit(q); }});
    add({"beyond_the_light", "something stands beyond the light only, and you say in shadow",
         [](const WrongAnswer& w) { return says_dark(w) && is_beyond(w.question); },
         [](const Case& q) { return lit(q) && is_beyond(q); }});
    add({"ends_before_the_light", "what is in the way stands just before the light, and you say lit",
         [](const WrongAnswer& w) { return says_lit(w) && first_block(w.question) > 0.9; }});
    add({"too_far", "what is in the way stands close to the point, and you say lit",
         [](const WrongAnswer& w) { return says_lit(w) && is_close(w.question); }});
    add({"units_of_t", "you say lit where what is in the way is farther than a metre, or in shadow beyond the light",
         [](const WrongAnswer& w) {
             return says_lit(w) ? first_block(w.question) * distance_of(w.question) > 1 : is_beyond(w.question);
         },
         [](const Case& q) {
             return !is_behind(of(q)) && first_block(q) < 1 && first_block(q) * distance_of(q) > 1.01;
         }});
    add({"units_of_t", "whether you are wrong depends on whether the light is nearer than a metre or farther",
         [](const WrongAnswer& w) { return says_dark(w) ? is_beyond(w.question) : distance_of(w.question) < 1; },
         [](const Case& q) {
             return (lit(q) && is_beyond(q) && distance_of(q) > 2.5) ||
                    (!is_behind(of(q)) && first_block(q) < 1 && first_block(q) > distance_of(q));
         }});
    add({"intersects_itself", "nothing is in the way, and you say in shadow", says_dark, lit});
    add({"intersects_itself", "something behind the point counts",
         [](const WrongAnswer& w) { return says_dark(w) && is_behind_point(w.question); },
         [](const Case& q) { return lit(q) && is_behind_point(q); }});
    add({"never_dark", "something is in the way, and you say lit", says_lit,
         [](const Case& q) { return !is_behind(of(q)) && !lit(q); }});
    add({"inside_out", "you say lit for in shadow, and in shadow for lit", [](const WrongAnswer&) { return true; },
         [](const Case&) { return true; }});
    return of_numbers(std::move(all));
}

}  // namespace raylab::grading::shadow
