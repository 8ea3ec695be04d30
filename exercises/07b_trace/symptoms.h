#pragma once

#include "arguments.h"
#include "symptom.h"

#include <cmath>
#include <functional>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::trace {

/// A level in numbers: what it would bring, and what is left of the depth.
struct Told {
    Arguments given;
    TracedSurface surface;
    bool hit, last, total;
};
inline Told told(const Case& question) {
    auto given = arguments(question.input);
    const bool hit = given.level.nearest.has_value();
    const TracedSurface surface = given.level.nearest.value_or(TracedSurface{{0, 0, 0}, 0, 0, {0, 0, 0}, {}});
    const bool last = given.level.depth + 1 > given.level.limit;
    return {std::move(given), surface, hit, last, hit && surface.kt > 0 && !surface.refracted};
}

inline Vec3d color_in(std::span<const double> answer) { return {answer[0], answer[1], answer[2]}; }
inline bool is_color(const WrongAnswer& w, const Vec3d& color) {
    return glm::length(color_in(w.given) - color) <= 1e-7 * std::max(1.0, glm::length(color));
}
inline bool right_color(const WrongAnswer& w) { return is_color(w, color_in(w.right)); }
inline double rays_of(std::span<const double> answer) { return answer[3] + answer[5]; }

inline Vec3d brought(const Told& t, double mirror, double through) {
    return mirror * t.given.mirrored_brings + (t.surface.refracted ? through : 0) * t.given.refracted_brings;
}

/// What both rays bring before the limit.
inline Vec3d right_brought(const Told& t) {
    return brought(t, t.total ? t.surface.kr + t.surface.kt : t.surface.kr, t.surface.kt);
}
inline Vec3d mirror_brought(const Told& t) {
    return brought(t, t.total ? t.surface.kr + t.surface.kt : t.surface.kr, 0);
}

/// The colour is this one, wherever it is not the right one.
inline Symptom instead(const std::string& hint, const std::string& words, Vec3d (*other)(const Told&)) {
    return {hint, words, [other](const WrongAnswer& w) { return is_color(w, other(told(w.question))); },
            [other](const Case& question) {
                const auto t = told(question);
                const Vec3d right = t.surface.local + right_brought(t);
                return t.hit && !t.last && glm::length(other(t) - right) > 1e-6 * std::max(1.0, glm::length(right));
            }};
}

/// Whether rays go on from here that bring something, by these of the surface's numbers.
inline bool goes_on(const Case& question) {
    const auto t = told(question);
    return t.hit && !t.last && (t.surface.kr > 0 || t.surface.kt > 0);
}

/// No ray goes on from surfaces of one kind.
inline Symptom none_from(const std::string& words, bool (*is_kind)(const TracedSurface&)) {
    const auto is_there = [is_kind](const Case& q) { return goes_on(q) && is_kind(told(q).surface); };
    return {"each_ray_by_itself", words,
            [is_there](const WrongAnswer& w) { return is_there(w.question) && rays_of(w.given) == 0; }, is_there};
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto is_last = [](const Case& q) { return told(q).last && told(q).hit; };
    add({"background_forgotten", "nothing is hit, and the colour is not the background",
         [](const WrongAnswer& w) { return !told(w.question).hit; }});
    // As if every ray were an eye ray: where its own depth is 1 that is right.
    const auto depth_counts = [](const Case& q) {
        const auto t = told(q);
        return t.hit && t.given.level.depth > 1 && t.given.level.limit > 1 && (t.surface.kr > 0 || t.surface.kt > 0);
    };
    add({"depth_of_its_own", "the rays that you trace are those of an eye ray, of depth 2, whatever depth arrived",
         [](const WrongAnswer& w) {
             const auto t = told(w.question);
             const bool mirror = w.given[3] > 0, through = w.given[5] > 0;
             return t.hit && t.given.level.depth > 1 && (mirror || through) && (!mirror || w.given[4] == 2) &&
                    (!through || w.given[6] == 2) && is_color(w, t.surface.local + right_brought(t));
         },
         depth_counts});
    add({"depth_not_counted", "the colour is right, and the depth handed on is not one more", [](const WrongAnswer& w) {
             return right_color(w) && rays_of(w.given) == rays_of(w.right) && rays_of(w.right) > 0 && w.given[7] == 0;
         }});
    const auto has_two_rays = [](const Case& q) {
        const auto t = told(q);
        return goes_on(q) && t.surface.kr > 0 && t.surface.kt > 0 && t.surface.refracted;
    };
    const auto counts_again = [](const WrongAnswer& w, std::size_t first, std::size_t second) {
        const double next = told(w.question).given.level.depth + 1;
        const bool is_end = told(w.question).given.level.limit <= next;  // for the second there is no level left
        return w.given[first] == 1 && w.given[first + 1] == next &&
               (w.given[second] == 1 ? w.given[second + 1] == next + 1 : is_end && w.given[second] == 0);
    };
    all.insert(all.end() - 1, {"depth_counted_twice", "of two rays the one is a level deeper than the other",
                               [=](const WrongAnswer& w) {
                                   return has_two_rays(w.question) && (counts_again(w, 3, 5) || counts_again(w, 5, 3));
                               },
                               has_two_rays});
    add({"counts_downward", "the depth handed on is one less than that of the ray that arrived",
         [](const WrongAnswer& w) {
             const double less = told(w.question).given.level.depth - 1;
             const bool mirror = w.given[3] > 0, through = w.given[5] > 0;
             return (mirror || through) && (!mirror || w.given[4] == less) && (!through || w.given[6] == less);
         }});
    add({"wrong_direction", "a ray is traced in no direction of the surface's",
         [](const WrongAnswer& w) { return w.given[7] > 0; }});
    add({"black_at_the_limit", "at the limit you give black",
         [](const WrongAnswer& w) {
             return told(w.question).last && is_color(w, {0, 0, 0});
         },
         is_last});
    add({"black_at_the_limit", "at the limit you give the background, not the surface's own colour",
         [](const WrongAnswer& w) {
             return told(w.question).last && is_color(w, told(w.question).given.level.background);
         },
         is_last});
    add({"depth_off_by_one", "at the limit rays go on",
         [](const WrongAnswer& w) { return told(w.question).last && rays_of(w.given) > 0; }});
    const auto mirrors_by_total_alone = [](const Case& q) {
        return told(q).total && !told(q).last && told(q).surface.kr == 0;
    };
    add({"total_reflection_loses_kt", "all is reflected totally in glass that mirrors nothing, and no ray is traced",
         [](const WrongAnswer& w) { return told(w.question).total && rays_of(w.right) > 0 && rays_of(w.given) == 0; },
         mirrors_by_total_alone});
    const auto levels_left = [](const Case& q) { return told(q).given.level.limit - told(q).given.level.depth; };
    for (const int levels : {1, 2})
        add({"one_level_short",
             levels == 1 ? "one level before the limit no ray goes on"
                         : "one level and two before the limit no ray goes on",
             [](const WrongAnswer& w) { return rays_of(w.given) == 0; },
             [=](const Case& q) { return goes_on(q) && levels_left(q) <= levels; }});
    add({"no_ray_goes_on", "before the limit no ray is traced",
         [](const WrongAnswer& w) { return goes_on(w.question) && rays_of(w.given) == 0; }, goes_on,
         [](const WrongAnswer& w) { return told(w.question).last && rays_of(w.given) > 0; }});
    add(none_from("no ray is traced where kr is 0, whatever kt is", [](const TracedSurface& s) { return s.kr == 0; }));
    add(none_from("no ray is traced where kt is 0, whatever kr is", [](const TracedSurface& s) { return s.kt == 0; }));
    add(none_from("no ray is traced where kr or kt is 0, whatever the other is",
                  [](const TracedSurface& s) { return s.kr == 0 || s.kt == 0; }));
    add(none_from("no ray is traced where there is no refracted one",
                  [](const TracedSurface& s) { return !s.refracted; }));
    add({"total_reflection_loses_kt", "under total internal reflection the mirror ray has the share kr alone",
         [](const WrongAnswer& w) {
             const auto t = told(w.question);
             return t.total && is_color(w, t.surface.local + brought(t, t.surface.kr, 0));
         },
         [](const Case& q) { return told(q).total && !told(q).last; }});
    add({"traced_twice", "the colour is right, and one ray is traced twice, for two shares of its",
         [](const WrongAnswer& w) {
             const auto is_again = [&](std::size_t i) { return w.right[i] == 1 && w.given[i] == 2; };
             return right_color(w) && (is_again(3) || is_again(5));
         }});
    add({"total_reflection_loses_kt", "all is reflected totally, and the colour is not right",
         [](const WrongAnswer& w) { return told(w.question).total && !right_color(w); },
         [](const Case& q) { return told(q).total && !told(q).last && told(q).surface.kr > 0; },
         [](const WrongAnswer& w) { return told(w.question).total && !right_color(w); }});
    add({"traces_for_nothing", "the colour is right, and rays are traced whose share is 0",
         [](const WrongAnswer& w) { return right_color(w) && rays_of(w.given) > rays_of(w.right); }});
    add(instead("shares_swapped", "kr and kt have changed places", [](const Told& t) {
        return t.surface.local +
               (t.total ? brought(t, t.surface.kr + t.surface.kt, 0) : brought(t, t.surface.kt, t.surface.kr));
    }));
    add(instead("shares_swapped", "kr and kt have changed places",
                [](const Told& t) { return t.surface.local + brought(t, t.surface.kt, t.surface.kr); }));
    add(instead("kt_twice", "the mirror ray has the share kr + kt, and kt goes to the refracted ray as well",
                [](const Told& t) { return t.surface.local + brought(t, t.surface.kr + t.surface.kt, t.surface.kt); }));
    add(instead("shares_forgotten", "what the rays bring counts whole", [](const Told& t) {
        const bool mirror = t.surface.kr > 0 || t.total, through = t.surface.kt > 0;
        return t.surface.local + brought(t, mirror ? 1 : 0, through ? 1 : 0);
    }));
    add(instead("what_is_left", "the refracted ray has the share that the mirror ray leaves, 1 - kr, and not kt",
                [](const Told& t) {
                    return t.surface.local + brought(t, t.total ? t.surface.kr + t.surface.kt : t.surface.kr,
                                                     t.surface.kt > 0 ? 1 - t.surface.kr : 0);
                }));
    add(instead("what_is_left", "the mirror ray has the share that the refracted ray leaves, 1 - kt, and not kr",
                [](const Told& t) {
                    return t.surface.local +
                           brought(t, t.surface.kr > 0 || t.total ? 1 - t.surface.kt : 0, t.surface.kt);
                }));
    const auto shares_of_one = [&](const std::string& words, Vec3d (*other)(const Told&)) {
        add(instead("what_is_left", words, other));
    };
    shares_of_one("kr and kt are divided by their sum, so that they are 1 together", [](const Told& t) {
        const double sum = t.surface.kr + t.surface.kt;
        return t.surface.local + (sum > 0 ? right_brought(t) / sum : Vec3d(0));
    });
    shares_of_one("the refracted ray has kt of what the mirror ray leaves, (1 - kr) kt", [](const Told& t) {
        return t.surface.local +
               (t.total ? right_brought(t) : brought(t, t.surface.kr, (1 - t.surface.kr) * t.surface.kt));
    });
    add(instead("tinted", "what the rays bring is multiplied by the local colour",
                [](const Told& t) { return t.surface.local + t.surface.local * right_brought(t); }));
    add(instead("tinted", "what the rays bring is multiplied by the local colour, which is missing by itself",
                [](const Told& t) { return t.surface.local * right_brought(t); }));
    add(instead("tinted", "what the mirror ray brings is multiplied by the local colour", [](const Told& t) {
        return t.surface.local + t.surface.local * mirror_brought(t) + (right_brought(t) - mirror_brought(t));
    }));
    add(instead("tinted", "what the refracted ray brings is multiplied by the local colour", [](const Told& t) {
        return t.surface.local + mirror_brought(t) + t.surface.local * (right_brought(t) - mirror_brought(t));
    }));
    add(instead("local_dimmed", "the local colour has the share 1 - kr - kt", [](const Told& t) {
        return (1 - t.surface.kr - t.surface.kt) * t.surface.local +
               brought(t, t.total ? t.surface.kr + t.surface.kt : t.surface.kr, t.surface.kt);
    }));
    add(instead("local_dimmed", "the local colour has the share 1 - kr", [](const Told& t) {
        return (1 - t.surface.kr) * t.surface.local +
               brought(t, t.total ? t.surface.kr + t.surface.kt : t.surface.kr, t.surface.kt);
    }));
    add(instead("local_dimmed", "the local colour has the share 1 - kt", [](const Told& t) {
        return (1 - t.surface.kt) * t.surface.local +
               brought(t, t.total ? t.surface.kr + t.surface.kt : t.surface.kr, t.surface.kt);
    }));
    add(instead("local_forgotten", "the local colour is missing", [](const Told& t) {
        return brought(t, t.total ? t.surface.kr + t.surface.kt : t.surface.kr, t.surface.kt);
    }));
    add({"local_twice", "the local colour is added once more than it should", [](const WrongAnswer& w) {
             const auto t = told(w.question);
             return is_color(w, color_in(w.right) + t.surface.local) ||
                    is_color(w, color_in(w.right) + 2.0 * t.surface.local);
         }});
    add({"one_ray_only", "glass traces its mirror ray, and no refracted one",
         [](const WrongAnswer& w) { return w.right[5] > 0 && w.given[5] == 0; }, has_two_rays,
         [](const WrongAnswer& w) { return w.right[5] > 0 && w.given[5] == 0; }});
    add({"one_ray_only", "glass traces its refracted ray, and no mirror ray",
         [](const WrongAnswer& w) { return w.right[3] > 0 && w.given[3] == 0; }, has_two_rays});
    add({"clamped", "the colour is cut off", [](const WrongAnswer& w) {
             const Vec3d right = color_in(w.right);
             return is_color(w, glm::min(right, Vec3d(1))) || is_color(w, glm::clamp(right, Vec3d(0), Vec3d(1)));
         }});
    return of_numbers(std::move(all));
}

}  // namespace raylab::grading::trace
