#pragma once

#include "dice.h"

#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// The numbers with which a function that draws at random is called: many pairs for one case, and each answer is kept. A
// right function may turn them into any points it likes, as long as all of them together are spread as they should be.

namespace raylab::grading {

/// Two numbers in [0, 1).
struct NumberPair {
    double u, v;
};

// A set has two independent random pairs in each of many equal cells of the unit square. Whatever a function does with
// them, a count of its points varies at most as much as with numbers that know no cells, so that a chi-square test is
// wrong no more often than it says; and the two answers of a cell tell how much a mean of all answers varies
// (spread.h).
inline constexpr std::size_t strata = 56;
inline constexpr std::size_t cells = strata * strata;
inline constexpr std::size_t pairs_in_set = 2 * cells;
inline constexpr std::size_t sets = 2;  // the second one is asked where the first one fails
inline constexpr std::size_t pairs = sets * pairs_in_set;

/// How the square is cut into cells: strata x strata squares, where a smooth function varies least; or as many strips
/// of one of the two numbers, which see what a function does with it in ever finer steps (an angle in degrees).
enum class Cells { squares, strips_of_u, strips_of_v };
inline constexpr std::uint64_t ways_to_cut = 3;

/// Which pairs a case is about, as its input says it.
namespace numbers {
inline constexpr double at_ends = 0;               // a grid with 0, 2^-53, halves, quarters and 1 - 2^-53
inline constexpr double rounded_to_one = 1;        // the same with 1, which numbers of a float's precision become
inline constexpr double first_seed = ways_to_cut;  // this and every larger whole number: sets of this seed
}  // namespace numbers

inline bool are_spread(double which) { return which >= numbers::first_seed; }

/// The cells of sets.
inline Cells cells_of(double which) { return static_cast<Cells>(static_cast<std::uint64_t>(which) % ways_to_cut); }

/// A seed of sets with these cells.
inline double spread_seed(Dice& dice, Cells cut) {
    const double any = std::floor(dice.in(1, 0x1p50));  // times 3 it still is a whole number
    return static_cast<double>(ways_to_cut) * any + static_cast<double>(cut);
}

/// The ways to cut in turn, for case after case.
inline Cells cells_in_turn(std::size_t i) { return static_cast<Cells>(i % ways_to_cut); }

inline std::vector<NumberPair> spread_pairs(std::uint64_t seed) {
    const Cells cut = cells_of(static_cast<double>(seed));
    const std::size_t columns = cut == Cells::squares ? strata : cut == Cells::strips_of_u ? cells : 1;
    const std::size_t rows = cells / columns;
    // The sum may round up to the next cell, and so to 1.
    const auto in_cell = [](std::size_t cell, std::size_t all, double random) {
        return std::min((static_cast<double>(cell) + random) / static_cast<double>(all), 1 - 0x1p-53);
    };
    std::vector<NumberPair> pairs_of_sets;
    for (std::size_t set = 0; set < sets; ++set)
        for (std::size_t cell = 0; cell < cells; ++cell)
            for (std::size_t twin = 0; twin < 2; ++twin) {
                RandomSequence random(seed, set * cells + cell, twin);
                const double u = in_cell(cell % columns, columns, random.next());
                pairs_of_sets.push_back({u, in_cell(cell / columns, rows, random.next())});
            }
    return pairs_of_sets;
}

inline std::vector<NumberPair> pairs_at_ends(double largest) {
    constexpr std::size_t side = 2 * strata;
    static_assert(side * side == pairs);
    const auto number = [&](std::size_t i) {
        return i == 1 ? 0x1p-53 : i == side - 1 ? largest : static_cast<double>(i) / side;
    };
    std::vector<NumberPair> all;
    for (std::size_t i = 0; i < pairs; ++i) all.push_back({number(i % side), number(i / side)});
    return all;
}

/// The pairs of a case, always as many.
inline std::vector<NumberPair> number_pairs(double which) {
    if (are_spread(which)) return spread_pairs(static_cast<std::uint64_t>(which));
    return pairs_at_ends(which == numbers::at_ends ? 1 - 0x1p-53 : 1.0);
}

}  // namespace raylab::grading
