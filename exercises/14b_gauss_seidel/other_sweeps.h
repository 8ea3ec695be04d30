#pragma once

#include "arguments.h"
#include "symptom.h"

#include <functional>
#include <utility>
#include <vector>

// Sweeps as somebody may have written them.

namespace raylab::grading::gauss_seidel {

/// A sweep as somebody may have written it: what patch i becomes, by the radiosities now and those before the sweep.
struct Moment {
    const RadiositySystem& system;
    const Radiosities &now, &before;
    std::size_t i;

    const Color& emission() const { return system.emission[i]; }
    const Color& reflectance() const { return system.reflectance[i]; }
    double own_share() const { return system.form_factors.at(i, i); }

    /// What arrives from the others, where patch j counts by weight(j).
    template <class Weight>
    Color from_others(const Radiosities& radiosity, const Weight& weight) const {
        Color sum(0);
        for (std::size_t j = 0; j < system.patches(); ++j)
            if (j != i) sum += weight(j) * radiosity[j];
        return sum;
    }
    Color from_others(const Radiosities& radiosity) const {
        return from_others(radiosity, [this](std::size_t j) { return system.form_factors.at(i, j); });
    }
    Color solved(const Color& right_side) const { return right_side / (1.0 - reflectance() * own_share()); }
};
using NewValue = std::function<Color(const Moment&)>;

inline RadiositySystem system_in(const Case& question) {
    std::span<const double> in = question.input;
    return system_of(taken(in, system_doubles));
}

inline Radiosities before_in(const Case& question) {
    std::span<const double> in = question.input;
    const auto patches = static_cast<std::size_t>(in[0]);
    return colors_of(in.subspan(system_doubles), patches);
}

inline bool sees_itself(const Case& question) { return system_in(question).form_factors.at(0, 0) > 0; }

enum class Order { forward, backward, there_and_back };

inline Radiosities swept(const Case& question, const NewValue& value, Order order = Order::forward, int sweeps = 1) {
    const RadiositySystem system = system_in(question);
    const Radiosities before = before_in(question);
    Radiosities now = before;
    const auto sweep = [&](Order one_way) {
        for (std::size_t k = 0; k < now.size(); ++k) {
            const std::size_t i = one_way == Order::forward ? k : now.size() - 1 - k;
            now[i] = value({system, now, before, i});
        }
    };
    for (int i = 0; i < sweeps; ++i) {
        sweep(order == Order::backward ? Order::backward : Order::forward);
        if (order == Order::there_and_back) sweep(Order::backward);
    }
    return now;
}

inline Color right_value(const Moment& m) { return m.solved(m.emission() + m.reflectance() * m.from_others(m.now)); }

/// Whether this sweep does not give what is right. One who is right there has made another mistake.
inline bool differs(const Case& question, const Radiosities& radiosity) {
    return !is_close(radiosity, swept(question, right_value), 1e-6);
}

inline bool gives(const WrongAnswer& wrong, const Radiosities& radiosity) {
    std::vector<double> other(outputs);
    put_colors(radiosity, other);
    return agree(wrong.given, other);
}

inline Symptom by(const std::string& hint, const std::string& words, const NewValue& value,
                  std::function<bool(const Case&)> where = {}) {
    return {hint, words, [value](const WrongAnswer& w) { return gives(w, swept(w.question, value)); },
            where ? std::move(where) : [value](const Case& q) { return differs(q, swept(q, value)); }};
}

}  // namespace raylab::grading::gauss_seidel
