#pragma once

#include "state.h"
#include "symptom.h"

#include <algorithm>

// What wrong answers have in common in which another patch shoots.

namespace raylab::grading::shooting {

inline double sum_of(const Color& color) { return color.r + color.g + color.b; }

/// Another patch shoots: the first for which this is largest. One who is right where that is another patch has made
/// another mistake.
inline Symptom chooses(const std::string& hint, const std::string& words, double (*weight)(const State&, std::size_t)) {
    const auto chosen_in = [weight](const State& before) {
        std::size_t chosen = 0;
        for (std::size_t i = 1; i < before.system.patches(); ++i)
            if (weight(before, i) > weight(before, chosen)) chosen = i;
        return chosen;
    };
    return {hint, words,
            [chosen_in](const WrongAnswer& w) {
                const std::size_t chosen = chosen_in(state_of(w.question.input));
                return w.given[0] != w.right[0] && w.given[0] == static_cast<double>(chosen);
            },
            [chosen_in](const Case& q) {
                const State before = state_of(q.input);
                return chosen_in(before) != shooter_of(before);
            }};
}

inline bool is_among_equals(const WrongAnswer& wrong) {
    const State before = state_of(wrong.question.input);
    const double given = wrong.given[0];
    return given != wrong.right[0] && given >= 0 && given < static_cast<double>(before.system.patches()) &&
           agree(power(before, static_cast<std::size_t>(given)), power(before, shooter_of(before)));
}

inline void add_choices(std::vector<Symptom>& all) {
    all.push_back(
        {"last_of_equals", "of two patches with the same power another than the first shoots", is_among_equals});
    all.push_back(chooses("brightest", "the patch with most unshot light per area shoots",
                          [](const State& s, std::size_t i) { return sum_of(s.unshot[i]); }));
    all.push_back(chooses("by_radiosity", "the patch shoots from which most power leaves, shot or not",
                          [](const State& s, std::size_t i) { return s.system.area[i] * sum_of(s.radiosity[i]); }));
    all.push_back(chooses("by_radiosity", "the patch shoots from which most light per area leaves, shot or not",
                          [](const State& s, std::size_t i) { return sum_of(s.radiosity[i]); }));
    all.push_back(
        chooses("by_radiosity", "the patch shoots that emits most power, shot or not",
                [](const State& s, std::size_t i) { return s.system.area[i] * sum_of(s.system.emission[i]); }));
    all.push_back(chooses("reflectance_in_choice", "the patch shoots whose unshot power times its reflectance is most",
                          [](const State& s, std::size_t i) {
                              return s.system.area[i] * sum_of(s.system.reflectance[i] * s.unshot[i]);
                          }));
    all.push_back(chooses("least_power", "the patch with least unshot power shoots",
                          [](const State& s, std::size_t i) { return -power(s, i); }));
    const std::string by_one = "the patch shoots that is chosen by one colour, or by the largest or a weighed mean";
    all.push_back(
        chooses("by_red", by_one, [](const State& s, std::size_t i) { return s.system.area[i] * s.unshot[i].r; }));
    all.push_back(
        chooses("by_red", by_one, [](const State& s, std::size_t i) { return s.system.area[i] * s.unshot[i].g; }));
    all.push_back(
        chooses("by_red", by_one, [](const State& s, std::size_t i) { return s.system.area[i] * s.unshot[i].b; }));
    all.push_back(chooses("by_red", by_one, [](const State& s, std::size_t i) {
        const Color& c = s.unshot[i];
        return s.system.area[i] * std::max({c.r, c.g, c.b});
    }));
    all.push_back(chooses("by_red", by_one, [](const State& s, std::size_t i) {
        const Color& c = s.unshot[i];
        return s.system.area[i] * std::min({c.r, c.g, c.b});
    }));
    all.push_back(chooses("by_red", by_one, [](const State& s, std::size_t i) {
        const Color& c = s.unshot[i];
        return s.system.area[i] * (0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b);
    }));
    all.push_back(chooses("by_red", by_one,
                          [](const State& s, std::size_t i) { return s.system.area[i] * glm::length(s.unshot[i]); }));
    all.push_back(
        chooses("by_red", "the patch shoots whose channels have the most when squared",
                [](const State& s, std::size_t i) { return s.system.area[i] * dot(s.unshot[i], s.unshot[i]); }));
    const std::string never = "the first patch, or the last, never shoots, though it has the most power";
    all.push_back(
        chooses("never_its_turn", never, [](const State& s, std::size_t i) { return i == 0 ? -1 : power(s, i); }));
    all.push_back(chooses("never_its_turn", never, [](const State& s, std::size_t i) {
        return i + 1 == s.system.patches() ? -1 : power(s, i);
    }));
}

}  // namespace raylab::grading::shooting
