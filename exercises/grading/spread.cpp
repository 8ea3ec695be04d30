#include "spread.h"

#include "raylab/sampling/chi_square.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <utility>

namespace raylab::grading {

namespace {

constexpr double alpha = 1e-5;
constexpr std::size_t parts = 8;  // of each side of the square: 98 points of a set are expected in each
constexpr std::size_t means = 10;
constexpr double alpha_of_each = alpha / (means + 1);

// What is no number is counted in the first part.
std::size_t part_of(double share) {
    return share > 0 ? static_cast<std::size_t>(std::min(share * parts, parts - 1.0)) : 0;
}

// What is 0 on average over the disk of which the square's points are squared radius and turn: polynomials of Zernike
// ("Beugungstheorie des Schneidenverfahrens", Physica 1, 1934), first of the radius alone, then of x, y, the second and
// the fourth turn (a map that keeps a square's corners is even in each eighth of the turn), then of both. They are
// smooth at the centre, where the turn itself is not: there a few square cells would decide. Strips go from one end to
// another, and there the turn itself counts: all points as if they were on the rim.
std::array<double, means> deviations(const DrawnShare& point, Cells cut) {
    const double squared = point.inside, turn = 2 * std::numbers::pi * point.turn;
    const double radius = cut == Cells::squares ? std::sqrt(squared) : 1;
    const double x = radius * std::cos(turn), y = radius * std::sin(turn);
    const double second = x * x - y * y, across = 2 * x * y;
    return {2 * squared - 1,
            6 * squared * (squared - 1) + 1,
            x,
            y,
            second,
            across,
            second * second - across * across,
            2 * second * across,
            (3 * squared - 2) * x,
            (3 * squared - 2) * y};
}

constexpr std::size_t of_inside = 2, of_turn = 6;  // how many of the means are about one of the two alone

// The probabilities that the means are this far from 0 by chance. Both points of a cell are independent and alike, so
// half their squared difference is on average the variance of either.
std::array<double, means> probabilities_of_means(std::span<const DrawnShare> set, Cells cut) {
    std::array<double, means> sums{}, squares{}, probabilities{};
    for (std::size_t i = 0; i + 1 < set.size(); i += 2) {
        const auto first = deviations(set[i], cut), second = deviations(set[i + 1], cut);
        for (std::size_t k = 0; k < means; ++k) {
            sums[k] += first[k] + second[k];
            squares[k] += (first[k] - second[k]) * (first[k] - second[k]);
        }
    }
    constexpr double rounding = 1e-9;  // of points that are all the same
    for (std::size_t k = 0; k < means; ++k)
        probabilities[k] = squares[k] > 0 ? chi_square_tail(sums[k] * sums[k] / squares[k], 1)
                           : std::abs(sums[k]) <= rounding * static_cast<double>(set.size()) ? 1
                                                                                             : 0;
    return probabilities;
}

std::vector<std::uint64_t> counts(std::span<const DrawnShare> points) {
    std::vector<std::uint64_t> all(parts * parts);
    for (const auto& [inside, turn] : points) ++all[part_of(inside) * parts + part_of(turn)];
    return all;
}

// The part of the square with the largest difference, among those that one side or both sides of it are cut into.
enum class Cut { inside, turn, both };

UnevenPart worst_part(std::span<const DrawnShare> set, Cut cut) {
    const auto found = counts(set);
    UnevenPart worst{};
    const auto look = [&](std::size_t inside0, std::size_t inside1, std::size_t turn0, std::size_t turn1) {
        double sum = 0;
        for (std::size_t i = inside0; i < inside1; ++i)
            for (std::size_t k = turn0; k < turn1; ++k) sum += static_cast<double>(found[i * parts + k]);
        const auto share = [](std::size_t part) { return static_cast<double>(part) / parts; };
        const UnevenPart part{share(inside0),
                              share(inside1),
                              share(turn0),
                              share(turn1),
                              (share(inside1) - share(inside0)) * (share(turn1) - share(turn0)),
                              sum / static_cast<double>(set.size())};
        if (std::abs(part.found - part.expected) > std::abs(worst.found - worst.expected)) worst = part;
    };
    for (std::size_t i = 0; i < parts; ++i) {
        if (cut == Cut::inside) look(0, i + 1, 0, parts);  // as a share that grows outwards
        if (cut == Cut::turn) look(0, parts, i, i + 1);
        for (std::size_t k = 0; cut == Cut::both && k < parts; ++k) look(i, i + 1, k, k + 1);
    }
    return worst;
}

// How many numbers differ by more than rounding does.
std::size_t different(std::vector<double> numbers) {
    constexpr double rounding = 1e-9;
    std::ranges::sort(numbers);
    std::size_t count = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) count += i == 0 || numbers[i] - numbers[i - 1] > rounding;
    return count;
}

}  // namespace

double turn_share(double x, double y) {
    const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
    return turn < 0 ? turn + 1 : turn;
}

std::optional<UnevenPart> uneven_part_of_set(std::span<const DrawnShare> set, Cells cut) {
    const auto probabilities = probabilities_of_means(set, cut);
    for (std::size_t which = 0; which < means; ++which)
        if (probabilities[which] < alpha_of_each) {
            const auto part = worst_part(set, which < of_inside             ? Cut::inside
                                              : which < of_inside + of_turn ? Cut::turn
                                                                            : Cut::both);
            // Both may be even by themselves, and a mean of both together not be what it should.
            return part.expected > 0 ? part : worst_part(set, Cut::both);
        }
    if (chi_square_p_value(counts(set)) < alpha_of_each) return worst_part(set, Cut::both);
    return std::nullopt;
}

std::optional<UnevenPart> uneven_part(std::span<const DrawnShare> points, Cells cut) {
    const auto first = uneven_part_of_set(points.first(pairs_in_set), cut);
    return first && uneven_part_of_set(points.subspan(pairs_in_set), cut) ? first : std::nullopt;
}

std::optional<Steps> steps_of(std::span<const DrawnShare> points) {
    for (const auto& [number, of] :
         {std::pair{&DrawnShare::turn, Steps::Of::turns}, std::pair{&DrawnShare::inside, Steps::Of::insides}}) {
        std::vector<double> numbers;
        for (const auto& point : points)
            if (std::isfinite(point.*number)) numbers.push_back(point.*number);
        const std::size_t values = different(numbers);
        if (10 * values < 9 * numbers.size()) return Steps{of, values};
    }
    return std::nullopt;
}

std::string steps_in_words(const Steps& steps, const std::string& insides, const std::string& turns) {
    return fmt::format("{} points and only {} {}", pairs, steps.values, steps.of == Steps::Of::turns ? turns : insides);
}

std::vector<double> spread_symptoms(std::span<const DrawnShare> points) {
    constexpr int waves = 4;
    std::vector<double> rings(parts);
    std::array<std::complex<double>, waves> around{}, outside_around{};
    for (const auto& [inside, turn] : points) {
        if (!std::isfinite(inside) || !std::isfinite(turn)) continue;
        rings[part_of(inside)] += 1;
        const auto wave = std::polar(1.0, 2 * std::numbers::pi * turn);
        std::complex<double> power = 1;
        for (std::size_t i = 0; i < waves; ++i) {
            power *= wave;
            around[i] += power;
            outside_around[i] += std::clamp(inside, 0.0, 1.0) * power;
        }
    }
    std::vector<double> symptoms = rings;
    for (const auto& sums : {around, outside_around})
        for (const auto& sum : sums) symptoms.push_back(std::abs(sum));
    for (double& symptom : symptoms) symptom /= static_cast<double>(points.size());
    return symptoms;
}

std::string numbers_in_words(double which) {
    if (are_spread(which))
        return fmt::format(
            "{} pairs: two in each of {}; and as many of another seed", pairs_in_set,
            cells_of(which) == Cells::squares
                ? fmt::format("{0} x {0} equal squares", strata)
                : fmt::format("{} equal strips of {}", cells, cells_of(which) == Cells::strips_of_u ? "u" : "v"));
    return fmt::format("{} pairs: a grid with 0, 2^-53, halves, quarters, and {}", pairs,
                       which == numbers::at_ends ? "1 - 2^-53" : "1");
}

}  // namespace raylab::grading
