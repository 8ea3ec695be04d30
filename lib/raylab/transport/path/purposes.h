#pragma once

// What a path's random numbers are used for. Each use has numbers of its own: two uses that shared one would depend on
// each other (case SAME-NUMBER-TWICE).

namespace raylab::purpose {

inline constexpr int picture = 0, lens = 1, time = 2;  // of the eye ray

/// At a vertex of a path, numbered from 0: the first surface that is hit.
enum AtVertex { light_choice, light_point, lobe_choice, lobe_direction, roulette, count };

constexpr int at(int vertex, AtVertex use) { return 3 + vertex * AtVertex::count + use; }

}  // namespace raylab::purpose
