#pragma once

#include "other_sweeps.h"

#include <algorithm>
#include <numbers>

// What wrong answers to this exercise have in common.

namespace raylab::grading::gauss_seidel {

/// One number of its reflectance is that of all channels.
inline NewValue in_grey(double (*number)(const Color&)) {
    return [number](const Moment& m) {
        const double rho = number(m.reflectance());
        return (m.emission() + rho * m.from_others(m.now)) / (1 - rho * m.own_share());
    };
}

/// The sum of what arrives is never set back to 0; a patch's own part may be in it.
inline NewValue added_up(bool with_own) {
    return [with_own, sum = Color(0)](const Moment& m) mutable {
        if (m.i == 0) sum = Color(0);
        sum += m.from_others(m.now);
        if (with_own) sum += m.own_share() * m.now[m.i];
        const Color value = m.emission() + m.reflectance() * sum;
        return with_own ? value : m.solved(value);
    };
}

inline bool is_light(const Moment& m) { return std::max({m.emission().r, m.emission().g, m.emission().b}) > 0; }

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"not_stored", "the radiosities are those before the sweep",
         [](const WrongAnswer& w) { return gives(w, before_in(w.question)); },
         [](const Case& q) { return differs(q, before_in(q)); }});
    add(by(
        "own_patch", "a patch sees itself, and its old radiosity is one of those that it receives",
        [](const Moment& m) {
            return m.emission() + m.reflectance() * (m.from_others(m.now) + m.own_share() * m.now[m.i]);
        },
        sees_itself));
    add(by(
        "own_patch_left_out", "a patch sees itself, and that light is missing",
        [](const Moment& m) { return m.emission() + m.reflectance() * m.from_others(m.now); }, sees_itself));
    add(by(
        "own_patch_twice", "a patch sees itself, and that light counts twice",
        [](const Moment& m) {
            return m.solved(m.emission() + m.reflectance() * (m.from_others(m.now) + m.own_share() * m.now[m.i]));
        },
        sees_itself));
    const std::string without_rho = "a patch sees itself, and its equation is divided as if it reflected all light";
    add(by(
        "own_reflectance", without_rho,
        [](const Moment& m) { return (m.emission() + m.reflectance() * m.from_others(m.now)) / (1 - m.own_share()); },
        sees_itself));
    add(by("divisor", "each equation is divided by 1 - rho_i, though most patches do not see themselves",
           [](const Moment& m) {
               return (m.emission() + m.reflectance() * m.from_others(m.now)) / (1.0 - m.reflectance());
           }));
    add({"own_equation", "all is right but where a patch sees itself",
         [](const WrongAnswer& w) { return sees_itself(w.question); }, sees_itself});
    const std::string one_left = "one patch, the first or the last, has kept its radiosity";
    add(by("not_all_visited", one_left, [](const Moment& m) { return m.i == 0 ? m.now[0] : right_value(m); }));
    add(by("not_all_visited", one_left,
           [](const Moment& m) { return m.i + 1 == m.now.size() ? m.now[m.i] : right_value(m); }));
    for (const double most : {1.0, 255.0})
        add(by("cut_off", "no radiosity is more than 1, or than 255",
               [most](const Moment& m) { return glm::min(right_value(m), Color(most)); }));
    add({"sum_goes_on", "what arrives at the patches before is counted again at the next one",
         [](const WrongAnswer& w) {
             return gives(w, swept(w.question, added_up(false))) || gives(w, swept(w.question, added_up(true)));
         }});
    add(by("emission_for_each", "what a patch emits counts once for each other patch", [](const Moment& m) {
        const auto others = static_cast<double>(m.now.size() - 1);
        return m.solved(others * m.emission() + m.reflectance() * m.from_others(m.now));
    }));
    // (Before Jacobi: from the beginning, where a patch has what it emits, both are the same.)
    const std::string emitted = "of other patches, or of those not reached yet, counts what they emit";
    add(by("emission_for_radiosity", emitted, [](const Moment& m) {
        return m.solved(m.emission() + m.reflectance() * m.from_others(m.system.emission));
    }));
    add(by("emission_for_radiosity", emitted, [](const Moment& m) {
        Radiosities known = m.system.emission;
        std::copy_n(m.now.begin(), m.i, known.begin());
        return m.solved(m.emission() + m.reflectance() * m.from_others(known));
    }));
    add(by("jacobi", "you give what a sweep of Jacobi gives",
           [](const Moment& m) { return m.solved(m.emission() + m.reflectance() * m.from_others(m.before)); }));
    add({"order", "the sweep goes from the last patch to the first",
         [](const WrongAnswer& w) { return gives(w, swept(w.question, right_value, Order::backward)); }});
    for (const int sweeps : {2, 3, 4, 5, 10, 20, 50, 100, 1000})
        add({"two_sweeps", "you give what several sweeps give", [sweeps](const WrongAnswer& w) {
                 return gives(w, swept(w.question, right_value, Order::forward, sweeps));
             }});
    add({"two_sweeps", "you give what a sweep there and another one back give",
         [](const WrongAnswer& w) { return gives(w, swept(w.question, right_value, Order::there_and_back)); }});
    add(by("row_and_column", "patch i receives by F_ji where F_ij belongs", [](const Moment& m) {
        return m.solved(m.emission() + m.reflectance() * m.from_others(m.now, [&](std::size_t j) {
            return m.system.form_factors.at(j, m.i);
        }));
    }));
    // What arrives is summed up once, and kept up to date as patches change: two places for the indices.
    const std::string kept_up = "patch i receives by F_ji where F_ij belongs, before a patch has changed or after it";
    add(by("row_and_column", kept_up, [](const Moment& m) {
        const Color first = m.from_others(m.before);
        const auto column = [&](std::size_t j) { return m.system.form_factors.at(j, m.i); };
        const Color changes = m.from_others(m.now, column) - m.from_others(m.before, column);
        return m.solved(m.emission() + m.reflectance() * (first + changes));
    }));
    add(by("row_and_column", kept_up, [](const Moment& m) {
        const auto column = [&](std::size_t j) { return m.system.form_factors.at(j, m.i); };
        const Color first = m.from_others(m.before, column);
        const Color changes = m.from_others(m.now) - m.from_others(m.before);
        return m.solved(m.emission() + m.reflectance() * (first + changes));
    }));
    add(by("reflectance", "patch i reflects by the reflectance of the patch that sends", [](const Moment& m) {
        return m.solved(m.emission() + m.from_others(m.now, [&](std::size_t j) {
            return m.system.reflectance[j] * m.system.form_factors.at(m.i, j);
        }));
    }));
    const std::string all_of_it = "patch i reflects all that arrives";
    add(by("reflectance_forgotten", all_of_it,
           [](const Moment& m) { return m.solved(m.emission() + m.from_others(m.now)); }));
    add(by("reflectance_forgotten", all_of_it,
           [](const Moment& m) { return (m.emission() + m.from_others(m.now)) / (1 - m.own_share()); }));
    add(by("emission", "what the patch emits is missing",
           [](const Moment& m) { return m.solved(m.reflectance() * m.from_others(m.now)); }));
    add(by("lights_reflect", "a patch that emits gets what it emits, and nothing else",
           [](const Moment& m) { return is_light(m) ? m.emission() : right_value(m); }));
    add(by("lights_reflect", "a patch gets what it emits or what it reflects, whichever is more",
           [](const Moment& m) { return glm::max(m.emission(), m.solved(m.reflectance() * m.from_others(m.now))); }));
    add(by("lights_reflect", "a patch that emits keeps the radiosity that it had",
           [](const Moment& m) { return is_light(m) ? m.now[m.i] : right_value(m); }));
    const std::string shared = "what the patch emits is multiplied by its reflectance";
    add(by("emission_reflected", shared,
           [](const Moment& m) { return m.solved(m.reflectance() * (m.emission() + m.from_others(m.now))); }));
    const std::string on_top = "the new radiosity is added to the old one";
    add(by("added", on_top, [](const Moment& m) { return m.now[m.i] + right_value(m); }));
    add(by("added", on_top,
           [](const Moment& m) { return m.now[m.i] + m.solved(m.reflectance() * m.from_others(m.now)); }));
    // Between the old radiosity and the new one, or beyond: any share of the step, the same in all patches.
    for (const double share : {0.5, 0.8, 0.9, 1.1, 1.2, 1.25, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9})
        add(by("relaxed", "each patch goes only a share of the way to its new radiosity, or beyond it",
               [share](const Moment& m) { return (1 - share) * m.now[m.i] + share * right_value(m); }));
    add(by("reflectance", "patch i reflects what it should keep: 1 - rho_i",
           [](const Moment& m) { return m.solved(m.emission() + (1.0 - m.reflectance()) * m.from_others(m.now)); }));
    add(by("row_made_whole", "what arrives is divided by the sum of the row", [](const Moment& m) {
        double sum = 0;
        for (std::size_t j = 0; j < m.now.size(); ++j)
            if (j != m.i) sum += m.system.form_factors.at(m.i, j);
        return m.solved(m.emission() + m.reflectance() * m.from_others(m.now) / sum);
    }));
    const std::string with_pi = "what is reflected is divided by pi, or multiplied";
    add(by("pi", with_pi, [](const Moment& m) {
        return m.solved(m.emission() + m.reflectance() / std::numbers::pi * m.from_others(m.now));
    }));
    add(by("pi", with_pi, [](const Moment& m) {
        return m.solved(m.emission() + m.reflectance() * std::numbers::pi * m.from_others(m.now));
    }));
    add(by("pi", with_pi, [](const Moment& m) {
        const Color rho = m.reflectance() / std::numbers::pi;
        return (m.emission() + rho * m.from_others(m.now)) / (1.0 - rho * m.own_share());
    }));
    const std::string some = "only the patches on one side of patch i count";
    add(by("only_those_before", some, [](const Moment& m) {
        return m.solved(m.emission() + m.reflectance() * m.from_others(m.now, [&](std::size_t j) {
            return j < m.i ? m.system.form_factors.at(m.i, j) : 0;
        }));
    }));
    add(by("only_those_before", some, [](const Moment& m) {
        return m.solved(m.emission() + m.reflectance() * m.from_others(m.now, [&](std::size_t j) {
            return j > m.i ? m.system.form_factors.at(m.i, j) : 0;
        }));
    }));
    const std::string areas = "what arrives is weighed by the ratio of two areas";
    add(by("area", areas, [](const Moment& m) {
        return m.solved(m.emission() + m.reflectance() * m.from_others(m.now, [&](std::size_t j) {
            return m.system.form_factors.at(m.i, j) * m.system.area[j] / m.system.area[m.i];
        }));
    }));
    add(by("area", areas, [](const Moment& m) {
        return m.solved(m.emission() + m.reflectance() * m.from_others(m.now, [&](std::size_t j) {
            return m.system.form_factors.at(m.i, j) * m.system.area[m.i] / m.system.area[j];
        }));
    }));
    add(by("area", areas, [](const Moment& m) {
        return m.solved(m.emission() + m.reflectance() * m.from_others(m.now, [&](std::size_t j) {
            return m.system.form_factors.at(j, m.i) * m.system.area[m.i] / m.system.area[j];
        }));
    }));
    const std::string grey = "the reflectance is the same in all channels";
    add(by("channels", grey, in_grey([](const Color& c) { return c.r; })));
    add(by("channels", grey, in_grey([](const Color& c) { return c.g; })));
    add(by("channels", grey, in_grey([](const Color& c) { return c.b; })));
    add(by("channels", grey, in_grey([](const Color& c) { return (c.r + c.g + c.b) / 3; })));
    return of_numbers(std::move(all));
}

}  // namespace raylab::grading::gauss_seidel
