#include "point_patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace raylab::grading {

namespace {

std::vector<double> turns_of(std::span<const DrawnShare> points) {
    std::vector<double> turns;
    for (const auto& point : points) turns.push_back(point.turn);
    return turns;
}

// How far a turn is from another, at most half a turn.
double apart(double a, double b) {
    const double difference = std::abs(a - b - std::floor(a - b));
    return std::min(difference, 1 - difference);
}

}  // namespace

bool are_even(std::vector<double> numbers) {
    std::erase_if(numbers, [](double x) { return !std::isfinite(x); });
    if (numbers.size() < pairs_in_set) return false;
    std::ranges::sort(numbers);
    const double count = static_cast<double>(numbers.size());
    double largest = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        largest = std::max({largest, std::abs(numbers[i] - static_cast<double>(i) / count),
                            std::abs(numbers[i] - static_cast<double>(i + 1) / count)});
    return largest < spread_noise;
}

bool have_even_insides_by(std::span<const DrawnShare> points, double (*law)(double inside)) {
    std::vector<double> numbers;
    for (const auto& point : points) numbers.push_back(law(point.inside));
    return are_even(std::move(numbers));
}

bool have_even_insides(std::span<const DrawnShare> points) {
    return have_even_insides_by(points, [](double inside) { return inside; });
}

bool have_even_turns(std::span<const DrawnShare> points) { return are_even(turns_of(points)); }

bool lie_on_a_curve(std::span<const DrawnShare> points) {
    std::vector<bool> has_any(cells);
    for (const auto& [inside, turn] : points) {
        const auto cell_of = [](double share) {
            return static_cast<std::size_t>(std::clamp(share, 0.0, 0.999) * strata);
        };
        if (std::isfinite(inside) && std::isfinite(turn)) has_any[cell_of(inside) * strata + cell_of(turn)] = true;
    }
    const auto taken = static_cast<std::size_t>(std::ranges::count(has_any, true));
    return taken > strata / 2 && taken < cells / 8;  // not all in one point
}

bool leave_out_turns(std::span<const DrawnShare> points) {
    std::vector<double> turns;
    for (const auto& [inside, turn] : points)
        if (inside > 0 && std::isfinite(turn)) turns.push_back(turn);  // the middle itself has no turn
    if (turns.empty()) return false;
    std::ranges::sort(turns);
    double widest = turns.front() + 1 - turns.back();
    for (std::size_t i = 1; i < turns.size(); ++i) widest = std::max(widest, turns[i] - turns[i - 1]);
    return widest > 0.05;
}

bool turn_by(std::span<const DrawnShare> points, std::span<const NumberPair> numbers, double turns) {
    constexpr double digits = 1e-7, nearly_all = 0.99;  // the middle itself has no turn
    const auto follow = [&](double NumberPair::*number, double sign) {
        const auto rest = [&](std::size_t i) { return points[i].turn - sign * turns * numbers[i].*number; };
        const std::size_t some = points.size() / 2;
        std::size_t agreeing = 0;
        for (std::size_t i = 0; i < points.size(); ++i) agreeing += apart(rest(i), rest(some)) < digits;
        return static_cast<double>(agreeing) > nearly_all * static_cast<double>(points.size());
    };
    return follow(&NumberPair::u, 1) || follow(&NumberPair::u, -1) || follow(&NumberPair::v, 1) ||
           follow(&NumberPair::v, -1);
}

bool turn_by_a_rounded_pi(std::span<const DrawnShare> points, std::span<const NumberPair> numbers) {
    constexpr std::array rounded{3.14, 3.142, 3.1416, 22.0 / 7};
    return std::ranges::any_of(rounded, [&](double pi) { return turn_by(points, numbers, pi / std::numbers::pi); });
}

bool turn_by_degrees(std::span<const DrawnShare> points, std::span<const NumberPair> numbers) {
    return turn_by(points, numbers, 180 / std::numbers::pi) || turn_by(points, numbers, 90 / std::numbers::pi);
}

bool have_whole_steps(std::span<const DrawnShare> points) {
    constexpr std::size_t few = 4;
    constexpr double end = 1e-9;
    std::vector<DrawnShare> inner;
    for (const auto& point : points)
        if (point.inside > end && point.inside < 1 - end) inner.push_back(point);
    const auto steps = steps_of(inner);
    return steps && steps->values >= few;
}

double mean_inside(std::span<const DrawnShare> points) {
    double sum = 0;
    for (const auto& point : points) sum += std::isfinite(point.inside) ? point.inside : 0;
    return sum / static_cast<double>(points.size());
}

}  // namespace raylab::grading
