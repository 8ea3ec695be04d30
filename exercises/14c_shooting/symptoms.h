#pragma once

#include "state.h"
#include "symptom.h"

#include <numbers>

// What wrong answers to this exercise have in common.

namespace raylab::grading::shooting {

/// A step as somebody may have written it: what it changes, where `shooter` shoots.
struct Step {
    const State& before;
    std::size_t shooter;
    State after;

    const RadiositySystem& system() const { return before.system; }
    const Color& sent() const { return before.unshot[shooter]; }
    Color reflected(std::size_t j) const { return received(before, shooter, sent(), j); }
};
inline double sum_of(const Color& color) { return color.r + color.g + color.b; }

/// What arrives at patch j, before anything is reflected.
inline Color arriving(const Step& s, std::size_t j) {
    return s.system().form_factors.at(s.shooter, j) * s.system().area[s.shooter] / s.system().area[j] * s.sent();
}

using Change = void (*)(Step&);
using Received = Color (*)(const Step&, std::size_t j);

inline bool gives(const WrongAnswer& wrong, const State& after) {
    std::vector<double> other(outputs);
    other[0] = wrong.given[0];
    put_colors(after.radiosity, std::span(other).subspan(1));
    put_colors(after.unshot, std::span(other).subspan(1 + color_doubles));
    return agree(wrong.given.subspan(1), std::span<const double>(other).subspan(1));
}

/// The right step, and then this change of it.
inline Symptom but(const std::string& hint, const std::string& words, Change change,
                   std::function<bool(const Case&)> where = {}) {
    return {hint, words,
            [change](const WrongAnswer& w) {
                const State before = state_of(w.question.input);
                Step step{before, shooter_of(before), shot(before)};
                change(step);
                return w.given[0] == w.right[0] && gives(w, step.after);
            },
            std::move(where)};
}

/// Another amount arrives at each patch.
inline Symptom arrives(const std::string& hint, const std::string& words, Received amount) {
    return {hint, words, [amount](const WrongAnswer& w) {
                const State before = state_of(w.question.input);
                Step step{before, shooter_of(before), before};
                step.after.unshot[step.shooter] = Color(0);
                for (std::size_t j = 0; j < before.system.patches(); ++j) {
                    const Color reflected = amount(step, j);
                    step.after.radiosity[j] += reflected;
                    step.after.unshot[j] += reflected;
                }
                return w.given[0] == w.right[0] && gives(w, step.after);
            }};
}

/// Another patch shoots: the first for which this is largest.
inline Symptom chooses(const std::string& hint, const std::string& words, double (*weight)(const State&, std::size_t)) {
    return {hint, words, [weight](const WrongAnswer& w) {
                const State before = state_of(w.question.input);
                std::size_t chosen = 0;
                for (std::size_t i = 1; i < before.system.patches(); ++i)
                    if (weight(before, i) > weight(before, chosen)) chosen = i;
                return w.given[0] != w.right[0] && w.given[0] == static_cast<double>(chosen);
            }};
}

inline bool shooter_sees_itself(const Case& question) {
    const State state = state_of(question.input);
    const std::size_t shooter = shooter_of(state);
    return state.system.form_factors.at(shooter, shooter) > 0 && power(state, shooter) > 0;
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

inline void add_amounts(std::vector<Symptom>& all) {
    const auto amount = [&](const std::string& hint, const std::string& words, Received other) {
        all.push_back(arrives(hint, words, other));
    };
    amount("area_ratio", "what arrives is not weighed by the two areas", [](const Step& s, std::size_t j) {
        return s.system().reflectance[j] * s.system().form_factors.at(s.shooter, j) * s.sent();
    });
    amount("area_ratio", "what arrives is divided by A_j, and not multiplied by A_s",
           [](const Step& s, std::size_t j) { return s.reflected(j) / s.system().area[s.shooter]; });
    amount("area_ratio_inverted", "what arrives is weighed by A_j / A_s", [](const Step& s, std::size_t j) {
        const double ratio = s.system().area[j] / s.system().area[s.shooter];
        return s.system().reflectance[j] * s.system().form_factors.at(s.shooter, j) * ratio * s.sent();
    });
    amount("row_and_column", "F_js stands where F_sj belongs", [](const Step& s, std::size_t j) {
        const double ratio = s.system().area[s.shooter] / s.system().area[j];
        return s.system().reflectance[j] * s.system().form_factors.at(j, s.shooter) * ratio * s.sent();
    });
    amount("power_received", "what arrives is power, and not power per area",
           [](const Step& s, std::size_t j) { return s.system().area[j] * s.reflected(j); });
    amount("reflectance", "patch j reflects by the reflectance of the patch that shoots",
           [](const Step& s, std::size_t j) {
               const double ratio = s.system().area[s.shooter] / s.system().area[j];
               return s.system().reflectance[s.shooter] * s.system().form_factors.at(s.shooter, j) * ratio * s.sent();
           });
    amount("reflectance_forgotten", "patch j reflects all that arrives", arriving);
    const std::string with_pi = "what is reflected is divided by pi, or multiplied";
    amount("pi", with_pi, [](const Step& s, std::size_t j) { return s.reflected(j) / std::numbers::pi; });
    amount("pi", with_pi, [](const Step& s, std::size_t j) { return s.reflected(j) * std::numbers::pi; });
    amount("all_radiosity", "all radiosity of the patch is sent out, shot or not", [](const Step& s, std::size_t j) {
        return received(s.before, s.shooter, s.before.radiosity[s.shooter], j);
    });
    amount("all_radiosity", "what the patch emits is sent out once more", [](const Step& s, std::size_t j) {
        return received(s.before, s.shooter, s.sent() + s.system().emission[s.shooter], j);
    });
    const std::string grey = "patch j reflects as much in all channels";
    amount("channels", grey,
           [](const Step& s, std::size_t j) { return sum_of(s.system().reflectance[j]) / 3 * arriving(s, j); });
    amount("channels", grey, [](const Step& s, std::size_t j) { return s.system().reflectance[j].r * arriving(s, j); });
    amount("channels", grey, [](const Step& s, std::size_t j) { return s.system().reflectance[j].g * arriving(s, j); });
    amount("channels", grey, [](const Step& s, std::size_t j) { return s.system().reflectance[j].b * arriving(s, j); });
    amount("emptied_too_early", "the patch shoots, and nothing arrives anywhere",
           [](const Step&, std::size_t) { return Color(0); });
}

/// Takes from patch j what it has received.
inline void take_back(Step& s, std::size_t j) {
    s.after.radiosity[j] = s.before.radiosity[j];
    s.after.unshot[j] = j == s.shooter ? Color(0) : s.before.unshot[j];
}

inline void add_accounts(std::vector<Symptom>& all) {
    const auto account = [&](const std::string& hint, const std::string& words, Change change) {
        all.push_back(but(hint, words, change));
    };
    account("unshot_kept", "all is right, but that the patch has kept what it shot",
            [](Step& s) { s.after.unshot[s.shooter] += s.sent(); });
    account("unshot_kept", "all is right, but that the patch has its emission to shoot again",
            [](Step& s) { s.after.unshot[s.shooter] += s.system().emission[s.shooter]; });
    account("radiosity_not_received", "the radiosities have not changed",
            [](Step& s) { s.after.radiosity = s.before.radiosity; });
    account("unshot_not_received", "what is unshot has not changed but for the patch that shoots", [](Step& s) {
        s.after.unshot = s.before.unshot;
        s.after.unshot[s.shooter] = Color(0);
    });
    const std::string darker = "the patch that shoots loses radiosity";
    account("goes_dark", darker, [](Step& s) { s.after.radiosity[s.shooter] -= s.sent(); });
    account("goes_dark", darker, [](Step& s) { s.after.radiosity[s.shooter] = Color(0); });
    account("goes_dark", darker, [](Step& s) { s.after.radiosity[s.shooter] = s.reflected(s.shooter); });
    const std::string replaced = "what arrives stands in place of what was there";
    account("overwritten", replaced, [](Step& s) {
        for (std::size_t j = 0; j < s.after.unshot.size(); ++j) s.after.unshot[j] = s.reflected(j);
    });
    account("overwritten", replaced, [](Step& s) {
        for (std::size_t j = 0; j < s.after.unshot.size(); ++j) s.after.radiosity[j] = s.reflected(j);
    });
    account("overwritten", replaced, [](Step& s) {
        for (std::size_t j = 0; j < s.after.unshot.size(); ++j)
            s.after.radiosity[j] = s.after.unshot[j] = s.reflected(j);
    });
    const std::string nothing = "the first patch, or the last, has received nothing";
    account("never_receives", nothing, [](Step& s) { take_back(s, s.after.unshot.size() - 1); });
    account("never_receives", nothing, [](Step& s) { take_back(s, 0); });
    all.push_back({"own_light_lost", "a concave patch shoots, and the light that it sends to itself is lost",
                   [](const WrongAnswer& w) { return w.given[0] == w.right[0] && shooter_sees_itself(w.question); },
                   shooter_sees_itself});
    all.push_back({"number_returned", "all is right but the number that is returned", [](const WrongAnswer& w) {
                       return w.given[0] != w.right[0] && agree(w.given.subspan(1), w.right.subspan(1));
                   }});
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    add_amounts(all);
    add_accounts(all);
    add_choices(all);
    return all;
}

}  // namespace raylab::grading::shooting
