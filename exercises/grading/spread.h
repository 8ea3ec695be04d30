#pragma once

#include "number_pairs.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// Whether points that a function drew at random are spread as they should be.

namespace raylab::grading {

/// A drawn point, by two numbers that are independent and uniform in [0, 1] where the function is right: the share of
/// the area, or of the solid angle, that lies nearer to the axis than the point, and the turn around the axis.
struct DrawnShare {
    double inside, turn;
};

/// The turn of the vector (x, y) around the origin as a share of the whole, from 0 to 1.
double turn_share(double x, double y);

/// A part of the unit square with too many points in it, or too few.
struct UnevenPart {
    double from_inside, to_inside, from_turn, to_turn;  // the part
    double expected, found;                             // shares of all points
};

/// Where the points of a case's sets (number_pairs.h) are not spread evenly; absent where they are. A set is refused
/// where chi-square over 8 x 8 parts, or one of ten means that must be 0, has a probability of less than 1e-5 by all
/// tests together; and a case where both of its sets are. So a right function fails once in 10^10 cases, if the tests
/// are what they say: of 160 000 sets of two right maps, each single test was below 1e-3 for 7e-4 to 1.4e-3 of them
/// (chi-square of a smooth map never), and below 1e-5 for 1.2e-5 of them. A density that is tilted by 1 %, a root to
/// the power of 0.505, and an angle in degrees are found (tests/exercises/spread.cpp).
std::optional<UnevenPart> uneven_part(std::span<const DrawnShare> points, Cells cut);

/// The same of one set, which alone is wrong of a right function once in 10^5 times.
std::optional<UnevenPart> uneven_part_of_set(std::span<const DrawnShare> set, Cells cut);

/// Points that leave gaps too narrow for chi-square: more than a tenth of them have the turn of another one, or its
/// inside, because something was rounded to whole steps. Of independent numbers two in 12544 are so near to each other
/// once in six cases, and of floats a handful in each.
struct Steps {
    enum class Of { insides, turns } of;
    std::size_t values;  // how many different ones there are
};
std::optional<Steps> steps_of(std::span<const DrawnShare> points);

/// "12544 points and only 360 directions": what is told of steps, by the names of what inside and turn are.
std::string steps_in_words(const Steps& steps, const std::string& insides, const std::string& turns);

/// How points are spread, in numbers that are nearly the same for two functions that spread them alike, whatever each
/// number did: the same mistake in another's code. Neither a turn of the whole nor a reflection changes them.
std::vector<double> spread_symptoms(std::span<const DrawnShare> points);

/// By so much the symptoms of one mistake differ: five standard deviations of a share of a case's points.
inline constexpr double spread_noise = 0.025;

/// "two in each of 56 x 56 equal squares": what the numbers of a case are.
std::string numbers_in_words(double which);

}  // namespace raylab::grading
