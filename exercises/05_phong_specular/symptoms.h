#pragma once

#include "arguments.h"
#include "symptom.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::highlight {

/// A case's vectors and their cosines.
struct Cosines {
    Arguments given;
    Vec3d n, l, v;      // unit
    double nl, nv, rv;  // of the normal with the light and the viewer, of the mirror direction with the viewer
};

inline Cosines cosines(const Case& question) {
    const auto given = arguments(question.input);
    const Vec3d n = glm::normalize(given.normal), l = glm::normalize(given.to_light),
                v = glm::normalize(given.to_viewer);
    return {given, n, l, v, dot(n, l), dot(n, v), 2 * dot(n, l) * dot(n, v) - dot(l, v)};
}

inline bool is_unit(const Vec3d& v) { return std::abs(glm::length(v) - 1) < 1e-9; }
inline bool is_lit(const Case& question) { return cosines(question).nl > 0 && cosines(question).rv > 0; }

inline double powered(double cosine, const Cosines& c) { return cosine > 0 ? std::pow(cosine, c.given.shininess) : 0; }
inline double right_one(const Cosines& c) { return c.nl > 0 ? powered(c.rv, c) : 0; }

/// The answer is this function of the case, not 0, wherever the light is before the surface. A viewer in the mirror
/// direction itself has all angles in one plane, where formulas agree that are different.
inline Symptom instead(const std::string& hint, const std::string& words, double (*other)(const Cosines&)) {
    const auto is_it = [other](const WrongAnswer& w) {
        const double value = other(cosines(w.question));
        return std::isnan(value) ? !std::isfinite(w.given[0])
                                 : std::abs(w.given[0] - value) <= 1e-9 * std::max(1.0, std::abs(value));
    };
    return {hint, words, [is_it](const WrongAnswer& w) { return cosines(w.question).rv < 1 - 1e-9 && is_it(w); },
            [other](const Case& q) {
                const auto c = cosines(q);
                return c.nl > 0 && !(std::abs(other(c) - right_one(c)) <= 1e-6);
            },
            is_it};
}

/// The cosine has this power, which is another one.
inline Symptom with_exponent(const std::string& hint, const std::string& words,
                             const std::function<double(double)>& exponent) {
    const auto is_other = [exponent](const Case& q) {
        const auto c = cosines(q);
        return is_lit(q) && std::abs(std::pow(c.rv, exponent(c.given.shininess)) - right_one(c)) > 1e-6;
    };
    return {hint, words,
            [exponent](const WrongAnswer& w) {
                const auto c = cosines(w.question);
                return is_lit(w.question) && agree(w.given[0], std::pow(c.rv, exponent(c.given.shininess)));
            },
            is_other};
}

/// Wrong where this vector is not unit; a shininess of 0 tells of another mistake, which many make as well.
inline Symptom not_unit(const std::string& hint, const std::string& words, Vec3d Arguments::*vector) {
    const auto is_long = [vector](const Case& q) { return !is_unit(arguments(q.input).*vector); };
    return {hint, words, [is_long](const WrongAnswer& w) { return is_long(w.question); },
            [is_long](const Case& q) { return is_lit(q) && q.input[9] > 0 && is_long(q); },
            [](const WrongAnswer& w) { return w.question.input[9] == 0; }};
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"light_behind", "the light is behind the surface, and you give a highlight",
         [](const WrongAnswer& w) { return cosines(w.question).nl <= 0 && w.given[0] != 0; }});
    add({"zero_to_the_zero", "the shininess is 0, the cosine is not positive, and you give 1",
         [](const WrongAnswer& w) { return w.question.input[9] == 0 && w.right[0] == 0 && agree(w.given[0], 1); }});
    add({"zero_to_the_zero", "the shininess is 0, the cosine is positive, and you give 0",
         [](const WrongAnswer& w) { return w.question.input[9] == 0 && w.given[0] == 0; },
         [](const Case& q) { return q.input[9] == 0 && is_lit(q); }});
    add({"cut_after_power", "the angle is more than a right one, and you give a highlight where the power is even",
         [](const WrongAnswer& w) {
             const auto c = cosines(w.question);
             return c.rv <= 0 && std::fmod(c.given.shininess, 2) == 0 && w.given[0] > 0;
         }});
    add({"negative_cosine", "the angle is more than a right one, and you give something other than 0",
         [](const WrongAnswer& w) {
             return cosines(w.question).nl > 0 && cosines(w.question).rv <= 0 && w.given[0] != 0;
         }});
    add({"viewer_behind", "the viewer is below the horizon, and you give 0",
         [](const WrongAnswer& w) { return cosines(w.question).nv <= 0 && w.given[0] == 0; },
         [](const Case& q) { return cosines(q).nv <= 0 && is_lit(q); }});
    add(not_unit("normal_not_unit", "the normal is not of length 1", &Arguments::normal));
    add(not_unit("light_not_unit", "the vector to the light is not of length 1", &Arguments::to_light));
    add(not_unit("viewer_not_unit", "the vector to the viewer is not of length 1", &Arguments::to_viewer));
    const auto any_length = [](const Case& q) {
        const auto given = arguments(q.input);
        return !is_unit(given.normal) || !is_unit(given.to_light) || !is_unit(given.to_viewer);
    };
    add({"nothing_unit", "one of the vectors is not of length 1",
         [any_length](const WrongAnswer& w) { return any_length(w.question); },
         [any_length](const Case& q) { return is_lit(q) && q.input[9] > 0 && any_length(q); },
         [](const WrongAnswer& w) { return w.question.input[9] == 0; }});
    add(instead("exponent_forgotten", "you give the cosine itself", [](const Cosines& c) { return c.rv; }));
    all.back().where = [](const Case& q) {
        const auto c = cosines(q);
        return is_lit(q) && std::abs(powered(c.rv, c) - c.rv) > 1e-6;
    };
    add(instead("approximation", "you give Schlick's fraction, c / (s - s c + c)", [](const Cosines& c) {
        const double s = c.given.shininess;
        return c.rv > 0 ? c.rv / (s - s * c.rv + c.rv) : 0;
    }));
    add(instead("approximation", "you give a bell curve of the angle, exp(-s angle^2 / 2)", [](const Cosines& c) {
        const double angle = std::acos(std::clamp(c.rv, -1.0, 1.0));
        return c.rv > 0 ? std::exp(-c.given.shininess * angle * angle / 2) : 0;
    }));
    add(instead("exponent_as_factor", "you give the cosine times the shininess",
                [](const Cosines& c) { return c.rv * c.given.shininess; }));
    add(instead("times_lambert", "the highlight is multiplied by the cosine at the light",
                [](const Cosines& c) { return c.nl * powered(c.rv, c); }));
    add(instead("half_vector", "you give Blinn's highlight, by the half vector",
                [](const Cosines& c) { return powered(dot(c.n, glm::normalize(c.l + c.v)), c); }));
    add(instead("half_vector", "you give Blinn's highlight with twice the shininess", [](const Cosines& c) {
        const double cosine = dot(c.n, glm::normalize(c.l + c.v));
        return cosine > 0 ? std::pow(cosine, 2 * c.given.shininess) : 0;
    }));
    add(instead("half_vector", "you give Blinn's highlight with four times the shininess", [](const Cosines& c) {
        const double cosine = dot(c.n, glm::normalize(c.l + c.v));
        return cosine > 0 ? std::pow(cosine, 4 * c.given.shininess) : 0;
    }));
    add(instead("in_the_plane", "you compare the angles that light and viewer make with the normal",
                [](const Cosines& c) {
                    const auto angle = [](double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); };
                    return c.nl > 0 ? powered(std::cos(angle(c.nv) - angle(c.nl)), c) : 0;
                }));
    add(instead("in_the_plane", "you take twice the angle between the normal and the half vector",
                [](const Cosines& c) {
                    const double half = dot(c.n, glm::normalize(c.l + c.v));
                    return c.nl > 0 ? powered(2 * half * half - 1, c) : 0;
                }));
    const auto exponent = [&](const std::string& words, double (*changed)(double)) {
        all.push_back(with_exponent("another_exponent", words, changed));
    };
    for (const double least : {1.0, 2.0})
        add(with_exponent("least_exponent", "the exponent is never less than a number of yours",
                          [least](double s) { return std::max(s, least); }));
    exponent("the exponent is half of the shininess", [](double s) { return s / 2; });
    exponent("the exponent is a quarter of the shininess", [](double s) { return s / 4; });
    exponent("the exponent is twice the shininess", [](double s) { return 2 * s; });
    exponent("the exponent is four times the shininess", [](double s) { return 4 * s; });
    exponent("the exponent is one more than the shininess", [](double s) { return s + 1; });
    exponent("the exponent is one less than the shininess", [](double s) { return s - 1; });
    exponent("the exponent is the shininess without its fraction", [](double s) { return std::floor(s); });
    exponent("the exponent is the shininess, rounded", [](double s) { return std::round(s); });
    exponent("the exponent is the shininess, rounded up", [](double s) { return std::ceil(s); });
    add({"base_and_exponent", "you give the shininess to the power of the cosine", [](const WrongAnswer& w) {
             const auto c = cosines(w.question);
             return is_lit(w.question) && agree(w.given[0], std::pow(c.given.shininess, c.rv));
         }});
    const auto factor = [&](double (*of)(double shininess)) {
        all.push_back({"scaled", "you give the right highlight times a factor that grows with the shininess",
                       [of](const WrongAnswer& w) {
                           const double s = cosines(w.question).given.shininess;
                           return is_lit(w.question) && agree(w.given[0], of(s) * w.right[0]);
                       }});
    };
    factor([](double s) { return (s + 2) / (2 * std::numbers::pi); });
    factor([](double s) { return (s + 1) / (2 * std::numbers::pi); });
    factor([](double s) { return (s + 8) / (8 * std::numbers::pi); });
    factor([](double s) { return (s + 2) / 2; });
    add(instead("to_normal", "the angle is that between the viewer and the normal",
                [](const Cosines& c) { return powered(c.nv, c); }));
    add(instead("to_light", "the angle is that between the viewer and the light",
                [](const Cosines& c) { return powered(dot(c.l, c.v), c); }));
    add(instead("mirrored_into_surface", "the mirror direction points into the surface",
                [](const Cosines& c) { return powered(-c.rv, c); }));
    add(instead("angle_for_cosine", "the power is that of the angle, not of its cosine",
                [](const Cosines& c) { return std::pow(std::acos(std::clamp(c.rv, -1.0, 1.0)), c.given.shininess); }));
    add(instead("diffuse", "you give the diffuse cosine, N.L", [](const Cosines& c) { return c.nl; }));
    add(instead("mirror_not_doubled", "the 2 is missing in 2 (N.L) N - L",
                [](const Cosines& c) { return powered(c.nl * c.nv - dot(c.l, c.v), c); }));
    add(instead("mirror_not_doubled", "the 2 is missing in 2 (N.L) N - L, which is made unit",
                [](const Cosines& c) { return powered(dot(glm::normalize(c.nl * c.n - c.l), c.v), c); }));
    return of_numbers(std::move(all));
}

}  // namespace raylab::grading::highlight
