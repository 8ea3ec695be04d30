#pragma once

#include "arguments.h"
#include "symptom.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::refraction {

inline Arguments of(const Case& question) { return arguments(question.input); }

/// A refraction as somebody may have put it down.
struct Bend {
    double eta, cosine, inner;  // the ratio of the indices, N.D turned positive, cos^2 behind
};
inline Bend bend(const Case& question) {
    const auto g = of(question);
    const double eta = g.ior_before / g.ior_behind, cosine = -dot(g.direction, g.normal);
    return {eta, cosine, 1 - eta * eta * (1 - cosine * cosine)};
}

inline Vec3d direction_in(std::span<const double> answer) { return {answer[1], answer[2], answer[3]}; }
inline bool gives(const WrongAnswer& w, const Vec3d& v) {
    return w.given[0] == 1 && glm::length(direction_in(w.given) - v) <= 1e-7 * std::max(1.0, glm::length(v));
}
inline bool is_total(const Case& question) { return bend(question).inner < 0; }

/// None, where light gets out.
inline bool says_none(const WrongAnswer& w) { return w.right[0] == 1 && w.given[0] == 0; }

/// What many formulas give that do not ask for total reflection: the root of what is negative.
inline bool gives_no_number(const WrongAnswer& w) { return is_total(w.question) && std::isnan(w.given[1]); }

/// In the plane of direction and normal, by a sine and a cosine of the angle behind the surface.
inline Vec3d by_angle(const Arguments& g, const Bend& b, double sine, double cosine) {
    const Vec3d along = g.direction + b.cosine * g.normal;
    if (glm::length(along) < 1e-12) return -cosine * g.normal;
    return sine * glm::normalize(along) - cosine * g.normal;
}

/// Every direction given is this one, up to its length.
inline Symptom instead(const std::string& hint, const std::string& words,
                       Vec3d (*other)(const Arguments&, const Bend&)) {
    return {hint,
            words,
            [other](const WrongAnswer& w) {
                const Vec3d v = other(of(w.question), bend(w.question));
                return gives(w, v) || gives(w, glm::normalize(v));
            },
            {},
            [other](const WrongAnswer& w) {
                const bool is_number = !std::isnan(other(of(w.question), bend(w.question)).x);
                return says_none(w) || gives_no_number(w) || (!is_number && std::isnan(w.given[1]));
            }};
}

/// What is right one way through a surface, with the ratio of the indices turned round the other way.
inline Symptom turned_one_way(const std::string& words, bool (*is_turned)(double eta)) {
    const auto other_eta = [is_turned](const Bend& b) { return is_turned(b.eta) ? 1 / b.eta : b.eta; };
    const auto is_there = [is_turned](const Case& q) {
        const Bend b = bend(q);
        return is_turned(b.eta) && b.cosine < 0.999 && std::abs(b.eta - 1) > 1e-3;
    };
    return {"eta_inverted", words,
            [other_eta](const WrongAnswer& w) {
                const Bend b = bend(w.question);
                const double eta = other_eta(b), inner = 1 - eta * eta * (1 - b.cosine * b.cosine);
                const auto g = of(w.question);
                return inner >= 0 && gives(w, eta * g.direction + (eta * b.cosine - std::sqrt(inner)) * g.normal);
            },
            is_there,
            [other_eta](const WrongAnswer& w) {
                const double eta = other_eta(bend(w.question)), cosine = bend(w.question).cosine;
                return eta * eta * (1 - cosine * cosine) > 1 &&
                       (says_none(w) || (w.right[0] == 1 && std::isnan(w.given[1])));
            }};
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto total = [](const Case& q) { return is_total(q); };
    add({"total_reflection_forgotten", "all light is reflected, and you give no number: the root of what is negative",
         [](const WrongAnswer& w) { return is_total(w.question) && std::isnan(w.given[1]); }, total});
    add({"mirrors", "all light is reflected, and you give the mirror direction",
         [](const WrongAnswer& w) {
             const auto g = of(w.question);
             return is_total(w.question) && gives(w, g.direction - 2 * dot(g.direction, g.normal) * g.normal);
         },
         total});
    add({"zero_vector", "all light is reflected, and you give the vector (0, 0, 0)",
         [](const WrongAnswer& w) {
             return is_total(w.question) && w.given[0] == 1 && direction_in(w.given) == Vec3d{0, 0, 0};
         },
         total});
    add({"clamped", "all light is reflected, and you give a direction",
         [](const WrongAnswer& w) { return is_total(w.question) && w.given[0] == 1; }, total});
    // The cosine where the sine belongs, and only where a ray leaves the denser side.
    const auto is_small_cosine = [](const Case& q) { return bend(q).eta > 1 && bend(q).cosine < 1 / bend(q).eta; };
    add({"sine_for_cosine", "you compare the cosine, not the sine, with the ratio of the indices",
         [is_small_cosine](const WrongAnswer& w) {
             return is_small_cosine(w.question) ? says_none(w) : is_total(w.question) && w.given[0] == 1;
         },
         [is_small_cosine](const Case& q) { return is_small_cosine(q) != is_total(q); }});
    add({"straight_on", "you give the direction that came in",
         [](const WrongAnswer& w) { return gives(w, of(w.question).direction); }});
    add({"not_unit_length",
         "the direction is right and the length is not",
         [](const WrongAnswer& w) {
             const Vec3d v = direction_in(w.given);
             return w.right[0] == 1 && w.given[0] == 1 && glm::length(v) > 0 && !agree(glm::length(v), 1) &&
                    glm::length(glm::normalize(v) - direction_in(w.right)) < 1e-7;
         },
         {},
         gives_no_number});
    add({"comes_back", "the direction is mirrored at the surface: it comes back", [](const WrongAnswer& w) {
             const auto g = of(w.question);
             const Vec3d right = direction_in(w.right);
             return w.right[0] == 1 && gives(w, right - 2 * dot(right, g.normal) * g.normal);
         }});
    add({"sideways", "the direction is turned sideways: what lies along the surface has the wrong sign",
         [](const WrongAnswer& w) {
             const auto g = of(w.question);
             const Vec3d right = direction_in(w.right);
             return w.right[0] == 1 && gives(w, 2 * dot(right, g.normal) * g.normal - right);
         }});
    add(instead("eta_inverted", "the indices have changed places", [](const Arguments& g, const Bend& b) {
        const double eta = 1 / b.eta, inner = 1 - eta * eta * (1 - b.cosine * b.cosine);
        return eta * g.direction + (eta * b.cosine - std::sqrt(inner)) * g.normal;
    }));
    // None may be given for another reason: it shows wherever light gets through both ways round, and bends.
    const auto bends_both_ways = [](const Case& q) {
        const Bend b = bend(q);
        const double other = 1 - (1 - b.cosine * b.cosine) / (b.eta * b.eta);
        return b.inner > 0 && other > 0 && b.cosine < 0.999 && std::abs(b.eta - 1) > 1e-3;
    };
    all.back().where = bends_both_ways;
    add(instead("eta_inverted", "under the root the indices have changed places",
                [](const Arguments& g, const Bend& b) {
                    const double inner = 1 - (1 - b.cosine * b.cosine) / (b.eta * b.eta);
                    return b.eta * g.direction + (b.eta * b.cosine - std::sqrt(inner)) * g.normal;
                }));
    all.back().where = bends_both_ways;
    add(instead("eta_inverted", "before the direction the indices have changed places, and not under the root",
                [](const Arguments& g, const Bend& b) {
                    return g.direction / b.eta + (b.cosine / b.eta - std::sqrt(b.inner)) * g.normal;
                }));
    all.back().where = [](const Case& q) {
        const Bend b = bend(q);
        return b.inner > 0 && b.cosine < 0.999 && std::abs(b.eta - 1) > 1e-3;
    };
    add(turned_one_way("out of the denser medium the indices have changed places", [](double eta) { return eta > 1; }));
    add(turned_one_way("into the denser medium the indices have changed places", [](double eta) { return eta < 1; }));
    add(instead("angles_for_sines", "the angles are in the ratio of the indices",
                [](const Arguments& g, const Bend& b) {
                    const double behind = b.eta * std::acos(std::min(1.0, b.cosine));
                    return by_angle(g, b, std::sin(behind), std::cos(behind));
                }));
    add(instead("tangents_for_sines", "the tangents of the angles are in the ratio of the indices",
                [](const Arguments& g, const Bend& b) {
                    return b.eta / b.cosine * (g.direction + b.cosine * g.normal) - g.normal;
                }));
    for (const bool is_upright : {true, false})
        add({"sine_for_cosine",
             "the cosines of the angles are in the ratio of the indices",
             [is_upright](const WrongAnswer& w) {
                 const Bend b = bend(w.question);
                 const double cosine = is_upright ? b.eta * b.cosine : b.cosine / b.eta;
                 return cosine <= 1 && gives(w, by_angle(of(w.question), b, std::sqrt(1 - cosine * cosine), cosine));
             },
             {},
             [is_upright](const WrongAnswer& w) {
                 const Bend b = bend(w.question);
                 const double cosine = is_upright ? b.eta * b.cosine : b.cosine / b.eta;
                 return cosine > 1 && (says_none(w) || !std::isfinite(w.given[1]));
             }});
    add(instead("tangent_not_unit",
                "direction + c * normal is multiplied by the sine behind, and has the one before in it",
                [](const Arguments& g, const Bend& b) {
                    const double before = std::sqrt(std::max(0.0, 1 - b.cosine * b.cosine));
                    return by_angle(g, b, b.eta * before * before, std::sqrt(b.inner));
                }));
    add(instead("tangent_not_unit", "a unit vector along the surface is multiplied by eta, without the sine before",
                [](const Arguments& g, const Bend& b) { return by_angle(g, b, b.eta, std::sqrt(b.inner)); }));
    add(instead("not_squared", "eta is not squared under the root", [](const Arguments& g, const Bend& b) {
        return b.eta * g.direction + (b.eta * b.cosine - std::sqrt(1 - b.eta * (1 - b.cosine * b.cosine))) * g.normal;
    }));
    all.back().where = [](const Case& q) {  // also where all light is reflected, and this root still there
        const Bend b = bend(q);
        return 1 - b.eta * (1 - b.cosine * b.cosine) > 0 && b.cosine < 0.999 && std::abs(b.eta - 1) > 1e-3;
    };
    add(instead("root_forgotten", "the root is missing", [](const Arguments& g, const Bend& b) {
        return b.eta * g.direction + (b.eta * b.cosine - b.inner) * g.normal;
    }));
    add(instead("sine_for_cosine", "the sine stands for the cosine", [](const Arguments& g, const Bend& b) {
        return b.eta * g.direction + (b.eta * b.cosine - std::sqrt(1 - b.eta * b.eta * b.cosine * b.cosine)) * g.normal;
    }));
    add(instead("not_unit",
                "eta belongs to the whole part along the surface, and is missing in one of its two summands",
                [](const Arguments& g, const Bend& b) {
                    return b.eta * g.direction + (b.cosine - std::sqrt(b.inner)) * g.normal;
                }));
    add(instead("not_unit",
                "eta belongs to the whole part along the surface, and is missing in one of its two summands",
                [](const Arguments& g, const Bend& b) {
                    return g.direction + (b.eta * b.cosine - std::sqrt(b.inner)) * g.normal;
                }));
    add(instead("not_unit", "the part along the surface is taken to be eta * direction alone",
                [](const Arguments& g, const Bend& b) { return b.eta * g.direction - std::sqrt(b.inner) * g.normal; }));
    add(instead("not_unit", "eta is multiplied with the part along the normal, too",
                [](const Arguments& g, const Bend& b) {
                    return b.eta * (g.direction + (b.cosine - std::sqrt(b.inner)) * g.normal);
                }));
    add(instead("normal_turned", "N.D has the wrong sign", [](const Arguments& g, const Bend& b) {
        return b.eta * g.direction + (-b.eta * b.cosine - std::sqrt(b.inner)) * g.normal;
    }));
    add(instead("normal_turned", "N.D has the wrong sign", [](const Arguments& g, const Bend& b) {
        return b.eta * g.direction - (b.eta * b.cosine - std::sqrt(b.inner)) * g.normal;
    }));
    add(instead("mirrors", "you give the mirror direction",
                [](const Arguments& g, const Bend& b) { return g.direction + 2 * b.cosine * g.normal; }));
    add(instead("eta_left_out", "eta is missing before the direction", [](const Arguments& g, const Bend& b) {
        return g.direction + (b.cosine - std::sqrt(b.inner)) * g.normal;
    }));
    add({"normal_turned", "the sine is that of a direction whose part along the normal is doubled, and not taken off",
         [](const WrongAnswer& w) {
             const auto g = of(w.question);
             const Bend b = bend(w.question);
             const Vec3d along = b.eta * (g.direction - b.cosine * g.normal);
             const double inner = 1 - dot(along, along);
             return inner < 0 ? says_none(w) : gives(w, along - std::sqrt(inner) * g.normal);
         },
         [](const Case& q) { return bend(q).inner > 0 && bend(q).cosine < 0.999; }});
    add(instead("sine_of_cosine", "the square of the sine is taken to be 1 - cosine",
                [](const Arguments& g, const Bend& b) {
                    const double square = b.eta * b.eta * (1 - b.cosine);
                    return b.eta * g.direction + (b.eta * b.cosine - std::sqrt(1 - square)) * g.normal;
                }));
    add(instead("sine_of_cosine", "the square of the sine is taken to be 1 + cosine^2",
                [](const Arguments& g, const Bend& b) {
                    const double square = b.eta * b.eta * (1 + b.cosine * b.cosine);
                    return b.eta * g.direction + (b.eta * b.cosine - std::sqrt(1 - square)) * g.normal;
                }));
    all.back().allows = [](const WrongAnswer& w) {  // where that is more than 1, as it mostly is
        const Bend b = bend(w.question);
        return b.eta * b.eta * (1 + b.cosine * b.cosine) > 1 && (says_none(w) || std::isnan(w.given[1]));
    };
    add(instead("sine_of_cosine", "the square of the cosine behind is taken to be 1 + sine^2",
                [](const Arguments& g, const Bend& b) {
                    return b.eta * g.direction + (b.eta * b.cosine - std::sqrt(2 - b.inner)) * g.normal;
                }));
    add(instead("sine_of_cosine", "the sine is taken to be 1 - cosine", [](const Arguments& g, const Bend& b) {
        const double sine = b.eta * (1 - b.cosine);
        return b.eta * g.direction + (b.eta * b.cosine - std::sqrt(1 - sine * sine)) * g.normal;
    }));
    add({"refracts_too_little", "light gets out, and you give none", says_none});
    return of_numbers(std::move(all), {"total_reflection_forgotten", "sine_for_cosine"});
}

}  // namespace raylab::grading::refraction
