#pragma once

#include "spread.h"

#include <span>
#include <vector>

// What points that a wrong function drew at random have in common: by which law their distances grow, which turns they
// leave out, and what their turns are made of.

namespace raylab::grading {

/// Whether numbers are uniform in [0, 1], as far as a case's pairs can tell: Kolmogorov and Smirnov's distance is less
/// than spread_noise.
bool are_even(std::vector<double> numbers);

/// Whether insides or turns are even, each by itself.
bool have_even_insides(std::span<const DrawnShare> points);
bool have_even_turns(std::span<const DrawnShare> points);

/// Whether law(inside) is even: a distance that is drawn by a wrong power, say.
bool have_even_insides_by(std::span<const DrawnShare> points, double (*law)(double inside));

/// Whether all lie on a curve, and not in one point: of as many cells as there are points in a set, very few have any.
bool lie_on_a_curve(std::span<const DrawnShare> points);

/// Whether a twentieth of the turn or more has no point.
bool leave_out_turns(std::span<const DrawnShare> points);

/// Whether the turn of each point is `turns` times one of its two numbers, from any beginning, in any direction.
bool turn_by(std::span<const DrawnShare> points, std::span<const NumberPair> numbers, double turns);

/// The same with a pi that was typed in with a few digits.
bool turn_by_a_rounded_pi(std::span<const DrawnShare> points, std::span<const NumberPair> numbers);

/// The same with degrees instead of radians.
bool turn_by_degrees(std::span<const DrawnShare> points, std::span<const NumberPair> numbers);

/// Whether turns or insides have whole steps, and there are a few of them at least: a single one was not rounded. What
/// lies at either end of the insides does not count: it may have been cut off there.
bool have_whole_steps(std::span<const DrawnShare> points);

/// Where more points than there should be are: nearer to the middle, or farther from it.
double mean_inside(std::span<const DrawnShare> points);

}  // namespace raylab::grading
