#pragma once

#include "arguments.h"

// A system in the middle of shooting, and the right step.

namespace raylab::grading::shooting {

struct State {
    RadiositySystem system;
    Radiosities radiosity, unshot;
};

inline State state_of(std::span<const double> in) {
    const RadiositySystem system = system_of(taken(in, system_doubles));
    const Radiosities radiosity = colors_of(taken(in, color_doubles), system.patches());
    return {system, radiosity, colors_of(in, system.patches())};
}

inline double power(const State& state, std::size_t i) {
    return state.system.area[i] * (state.unshot[i].r + state.unshot[i].g + state.unshot[i].b);
}

inline std::size_t shooter_of(const State& state) {
    std::size_t shooter = 0;
    for (std::size_t i = 1; i < state.system.patches(); ++i)
        if (power(state, i) > power(state, shooter)) shooter = i;
    return shooter;
}

/// What patch j reflects of what the shooter sends: the power that arrives, over j's area; in long doubles, channel by
/// channel.
inline Color received(const State& state, std::size_t shooter, const Color& sent, std::size_t j) {
    const long double share = static_cast<long double>(state.system.form_factors.at(shooter, j)) *
                              state.system.area[shooter] / state.system.area[j];
    Color reflected;
    for (int channel = 0; channel < 3; ++channel)
        reflected[channel] = static_cast<double>(state.system.reflectance[j][channel] * share * sent[channel]);
    return reflected;
}

inline State shot(State state) {
    const std::size_t shooter = shooter_of(state);
    const Color sent = state.unshot[shooter];
    state.unshot[shooter] = Color(0);
    for (std::size_t j = 0; j < state.system.patches(); ++j) {
        const Color reflected = received(state, shooter, sent, j);
        state.radiosity[j] += reflected;
        state.unshot[j] += reflected;
    }
    return state;
}

}  // namespace raylab::grading::shooting
