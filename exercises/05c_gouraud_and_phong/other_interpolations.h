#pragma once

#include "questions.h"
#include "symptom.h"

#include <functional>

// The same interpolation with something else in a place, which is how wrong answers are known: each number is right or
// that of the other.

namespace raylab::grading::mesh_hit {

inline Arguments of(const Case& question) { return arguments(question.input); }

using Other = std::function<InterpolatedBrightness(const Arguments&)>;

/// Each number is the right one or the other's, and one is the other's.
inline bool is_instead(const WrongAnswer& w, const InterpolatedBrightness& other) {
    const auto is = [&](std::size_t i, double value) {
        return agree(w.given[i], value) || std::abs(w.given[i] - value) < 1e-9;
    };
    const bool right0 = is(0, w.right[0]), right1 = is(1, w.right[1]);
    return !(right0 && right1) && (right0 || is(0, other.gouraud)) && (right1 || is(1, other.phong));
}

/// Whether a case tells the other from what is right.
inline bool tells(const Arguments& given, const InterpolatedBrightness& other) {
    const auto [gouraud, phong] = truth(given);
    return std::abs(other.gouraud - gouraud) > 1e-6 || std::abs(other.phong - phong) > 1e-6;
}

/// The answer has the other's numbers: both of them, Phong's alone, or Gouraud's alone.
enum class Whose { both, phong, gouraud };
inline Symptom instead(const std::string& hint, const std::string& words, const Other& other,
                       Whose whose = Whose::both) {
    const auto of_these = [other, whose](const Arguments& given) {
        const auto [gouraud, phong] = other(given);
        const auto right = truth(given);
        return InterpolatedBrightness{whose == Whose::phong ? right.gouraud : gouraud,
                                      whose == Whose::gouraud ? right.phong : phong};
    };
    return {hint, words, [of_these](const WrongAnswer& w) { return is_instead(w, of_these(of(w.question))); },
            [of_these](const Case& question) { return tells(of(question), of_these(of(question))); }};
}

/// The right interpolations of other ingredients.
inline Other made_of(void (*change)(Ingredients&)) {
    return [change](const Arguments& given) {
        Ingredients made = ingredients(given.hit);
        change(made);
        return shaded(given.model, made);
    };
}

/// Adds the symptom of both numbers, of Phong's alone and of Gouraud's alone.
inline void add_instead(std::vector<Symptom>& all, const std::string& hint, const std::string& words,
                        const Other& other) {
    for (const Whose whose : {Whose::both, Whose::phong, Whose::gouraud})
        all.push_back(instead(hint, words, other, whose));
}

}  // namespace raylab::grading::mesh_hit
