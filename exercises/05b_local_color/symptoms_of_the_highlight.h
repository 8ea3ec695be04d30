#pragma once

#include "other_models.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// What wrong answers have in common whose highlight is another one, or has another factor.

namespace raylab::grading::local {

/// A negative R.V has this highlight: highlight(cosine, shininess). It may be no number.
inline Symptom of_negative_cosines(const std::string& words, double (*highlight)(double, double)) {
    const auto color = [highlight](const Case& question) {
        const Arguments given = arguments(question.input);
        return given.surface.unlit + sum_of(given, [highlight](const auto& s, const auto& l, const auto& seen) {
                   if (!(seen.incline > 0) || seen.mirrored >= 0) return right_share(s, l, seen);
                   return l.color * (terms_of(s, seen).diffuse + highlight(seen.mirrored, s.shininess) * s.specular) /
                          seen.falls;
               });
    };
    return {"negative_cosine", words,
            [color](const WrongAnswer& w) {
                const Vec3d other = color(w.question);
                return std::isnan(other.x) ? std::isnan(w.given[0]) : is_color(w, other);
            },
            [color](const Case& question) { return is_another(color(question), question); }};
}

inline void add_highlights(std::vector<Symptom>& all) {
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto negative_cosine = [&](double (*highlight)(double cosine, double shininess)) {
        add(of_negative_cosines("the viewer is more than a right angle from the mirror direction, and sees a highlight",
                                highlight));
    };
    negative_cosine([](double cosine, double shininess) { return std::pow(cosine, shininess); });
    negative_cosine([](double cosine, double shininess) { return std::pow(-cosine, shininess); });
    negative_cosine([](double cosine, double shininess) { return std::max(0.0, std::pow(cosine, shininess)); });
    // A factor of its own before one of the two terms: factor(shininess).
    const auto scaled = [&](const std::string& words, bool is_diffuse, double (*factor)(double)) {
        add(each_light("scaled", words, [=](const auto& s, const auto& l, const auto& seen) {
            auto [diffuse, specular] = terms_of(s, seen);
            (is_diffuse ? diffuse : specular) *= factor(s.shininess);
            return l.color * (diffuse + specular) / seen.falls;
        }));
    };
    scaled("the diffuse term is divided by pi", true, [](double) { return 1 / std::numbers::pi; });
    const std::string grows = "the highlight has a factor that grows with the shininess";
    scaled(grows, false, [](double s) { return (s + 2) / (2 * std::numbers::pi); });
    scaled(grows, false, [](double s) { return (s + 1) / (2 * std::numbers::pi); });
    scaled(grows, false, [](double s) { return (s + 8) / (8 * std::numbers::pi); });
    scaled(grows, false, [](double s) { return (s + 2) / 2; });
    add(each_light("scaled", "the diffuse colour is multiplied by 1 - specular",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return l.color * ((1.0 - s.specular) * diffuse + specular) / seen.falls;
                   }));
    for (const bool is_down : {true, false})
        add(each_light("whole_exponent", "the highlight's exponent is a whole number",
                       [is_down](const auto& s, const auto& l, const auto& seen) {
                           LocalSurface whole = s;
                           whole.shininess = is_down ? std::floor(s.shininess) : std::round(s.shininess);
                           const auto [diffuse, specular] = terms_of(whole, seen);
                           return l.color * (diffuse + specular) / seen.falls;
                       }));
    for (const int exponents : {1, 4})
        add(each_light("half_vector", "the highlight is Blinn's, by the half vector",
                       [exponents](const auto& s, const auto& l, const auto& seen) {
                           const double cosine = dot(s.normal, glm::normalize(s.to_viewer + glm::normalize(l.way)));
                           const double highlight = std::pow(highlight_by(s, cosine), exponents);
                           const Vec3d specular = seen.incline > 0 ? highlight * s.specular : Vec3d(0);
                           return l.color * (terms_of(s, seen).diffuse + specular) / seen.falls;
                       }));
    // The highlight by the cosine of another angle: cosine(surface, light, seen).
    const auto another_angle = [&](const std::string& words, const auto& cosine) {
        add(each_light("another_angle", words, [cosine](const auto& s, const auto& l, const auto& seen) {
            const double highlight = seen.incline > 0 ? highlight_by(s, cosine(s, l, seen)) : 0;
            return l.color * (terms_of(s, seen).diffuse + highlight * s.specular) / seen.falls;
        }));
    };
    another_angle("the highlight is where the mirror direction points into the surface",
                  [](const auto&, const auto&, const auto& seen) { return -seen.mirrored; });
    another_angle("the highlight is where the viewer looks along the normal",
                  [](const auto& s, const auto&, const auto&) { return dot(s.normal, s.to_viewer); });
    another_angle("the highlight is where the viewer looks from the light",
                  [](const auto& s, const auto& l, const auto&) { return dot(glm::normalize(l.way), s.to_viewer); });
}

}  // namespace raylab::grading::local
