#pragma once

#include "symptoms_of_choices.h"

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
/// What arrives at patch j, before anything is reflected.
inline Color arriving(const Step& s, std::size_t j) {
    return s.system().form_factors.at(s.shooter, j) * s.system().area[s.shooter] / s.system().area[j] * s.sent();
}

/// The share of what the shooter sends out that arrives anywhere.
enum class Own { counted, left_out };
inline double sum_of_row(const Step& s, Own own) {
    double sum = 0;
    for (std::size_t j = 0; j < s.system().patches(); ++j)
        if (own == Own::counted || j != s.shooter) sum += s.system().form_factors.at(s.shooter, j);
    return sum;
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

inline bool nothing_is_left(const Case& question) {
    const State state = state_of(question.input);
    return state.system.patches() > 1 && power(state, shooter_of(state)) == 0;
}

inline bool shooter_sees_itself(const Case& question) {
    const State state = state_of(question.input);
    const std::size_t shooter = shooter_of(state);
    return state.system.form_factors.at(shooter, shooter) > 0 && power(state, shooter) > 0;
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
    all.push_back(
        but("reflectance_forgotten", "what is left to shoot of patch j grows by all that arrives", [](Step& s) {
            for (std::size_t j = 0; j < s.system().patches(); ++j) s.after.unshot[j] += arriving(s, j) - s.reflected(j);
        }));
    const std::string with_pi = "what is reflected is divided by pi, or multiplied";
    amount("pi", with_pi, [](const Step& s, std::size_t j) { return s.reflected(j) / std::numbers::pi; });
    amount("pi", with_pi, [](const Step& s, std::size_t j) { return s.reflected(j) * std::numbers::pi; });
    amount("all_radiosity", "all radiosity of the patch is sent out, shot or not", [](const Step& s, std::size_t j) {
        return received(s.before, s.shooter, s.before.radiosity[s.shooter], j);
    });
    amount("all_radiosity", "what the patch emits is sent out once more", [](const Step& s, std::size_t j) {
        return received(s.before, s.shooter, s.sent() + s.system().emission[s.shooter], j);
    });
    const std::string whole = "what arrives is divided by the sum of the row";
    amount("row_made_whole", whole,
           [](const Step& s, std::size_t j) { return s.reflected(j) / sum_of_row(s, Own::counted); });
    amount("row_made_whole", whole,
           [](const Step& s, std::size_t j) { return s.reflected(j) / sum_of_row(s, Own::left_out); });
    const std::string in_equal_parts = "what arrives is divided by the number of patches, or of the others";
    amount("row_made_whole", in_equal_parts,
           [](const Step& s, std::size_t j) { return s.reflected(j) / static_cast<double>(s.system().patches()); });
    amount("row_made_whole", in_equal_parts, [](const Step& s, std::size_t j) {
        return s.reflected(j) / (static_cast<double>(s.system().patches()) - 1);
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
    all.push_back({"own_light_lost", "a concave patch shoots, and all others are right",
                   [](const WrongAnswer& w) { return w.given[0] == w.right[0] && shooter_sees_itself(w.question); },
                   shooter_sees_itself});
    all.push_back({"nothing_left", "nothing is left to shoot, and the number is not that of the first patch",
                   [](const WrongAnswer& w) { return nothing_is_left(w.question); }, nothing_is_left,
                   [](const WrongAnswer& w) {  // a room of one patch, of which many a wrong search is right
                       const State state = state_of(w.question.input);
                       return power(state, shooter_of(state)) == 0;
                   }});
    all.push_back({"number_returned", "all is right but the number that is returned", [](const WrongAnswer& w) {
                       return w.given[0] != w.right[0] && agree(w.given.subspan(1), w.right.subspan(1));
                   }});
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    add_amounts(all);
    add_accounts(all);
    add_choices(all);
    return of_numbers(std::move(all));
}

}  // namespace raylab::grading::shooting
