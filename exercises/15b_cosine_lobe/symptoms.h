#pragma once

#include "lobe_shares.h"
#include "point_patterns.h"
#include "symptom.h"

// What wrong answers to this exercise have in common.

namespace raylab::grading::cosine_lobe {

/// The directions of a wrong answer.
struct Directions {
    std::span<const double> given;
    double which;
    std::vector<DrawnShare> shares = lobe_shares(given);

    SampledDirection at(std::size_t i) const { return sampled(given, i); }
    std::vector<NumberPair> numbers() const { return number_pairs(which); }

    /// Of all directions that are numbers, the share of those for which holds(direction and density).
    template <class Holds>
    double share(const Holds& holds) const {
        std::size_t all = 0, some = 0;
        for (std::size_t i = 0; i < pairs; ++i) {
            const SampledDirection one = at(i);
            if (!is_finite(one)) continue;
            ++all;
            some += holds(one);
        }
        return all > 0 ? static_cast<double>(some) / static_cast<double>(all) : 0;
    }
    template <class Holds>
    bool nearly_all(const Holds& holds) const {
        return share(holds) > 0.99;
    }

    /// Whether law(inside) is even; a grid is too coarse to tell.
    bool may_be_even_by(double (*law)(double inside)) const {
        return !are_spread(which) || have_even_insides_by(shares, law);
    }
    bool may_be_right() const {
        return may_be_even_by([](double inside) { return inside; }) && (!are_spread(which) || have_even_turns(shares));
    }
    bool are_unit() const {
        return nearly_all([](const auto& one) { return std::abs(glm::length(one.direction) - 1) < 1e-9; });
    }
    /// Whether the density is this function of the cosine.
    bool say(double (*density)(double cosine)) const {
        return nearly_all([density](const auto& one) {
            return std::abs(one.pdf - density(one.direction.z)) < 1e-7 * std::max(1.0, std::abs(one.pdf));
        });
    }
    bool say_the_right_density() const {
        return say([](double cosine) { return cosine / std::numbers::pi; });
    }
    /// Whether the directions would be right if this axis, x or y, were the normal; a grid is too coarse to tell.
    bool may_be_right_around(int axis) const {
        std::vector<DrawnShare> others;
        for (std::size_t i = 0; i < pairs; ++i) {
            const Vec3d& d = at(i).direction;
            if (d[axis] < -1e-9) return false;
            others.push_back({1 - d[axis] * d[axis], turn_share(d[1 - axis], d.z)});
        }
        return !are_spread(which) || (have_even_insides(others) && have_even_turns(others));
    }
};

inline Symptom pattern(const std::string& hint, const std::string& words, bool (*shows)(const Directions&)) {
    return {hint, words, [shows](const WrongAnswer& w) { return shows(Directions{w.given, w.question.input[0]}); }};
}

/// Whether the direction of u = v = 1/2 is no number, and all others are.
inline bool are_lost_in_the_middle(const Directions& directions) {
    const auto numbers = directions.numbers();
    std::size_t lost = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        if (is_finite(directions.at(i))) continue;
        if (numbers[i].u != 0.5 || numbers[i].v != 0.5) return false;
        ++lost;
    }
    return lost > 0;
}

inline double cosine_of(double inside) { return std::sqrt(std::max(0.0, 1 - inside)); }

/// The density is this one, of directions that are as frequent as they should be.
inline Symptom says(const std::string& hint, const std::string& words, double (*density)(double cosine)) {
    return {hint, words, [density](const WrongAnswer& w) {
                const Directions d{w.given, w.question.input[0]};
                return d.are_unit() && d.may_be_right() && d.say(density);
            }};
}

inline void add_ways(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, bool (*shows)(const Directions&)) {
        all.push_back(pattern(hint, words, shows));
    };
    add("nothing_at_the_horizon", "a few directions along the horizon are no numbers, all others are right",
        [](const Directions& d) {
            std::size_t lost = 0;
            for (std::size_t i = 0; i < pairs; ++i) {
                if (is_finite(d.at(i))) continue;
                if (!(std::abs(d.shares[i].inside - 1) < 1e-9)) return false;
                ++lost;
            }
            return lost > 0 && d.say_the_right_density();
        });
    add("nothing_at_the_centre", "the only direction that is no number is that of u = v = 1/2", are_lost_in_the_middle);
    add("zero_length", "a few directions are no numbers, neither of their coordinates, and all others are right",
        [](const Directions& d) {
            std::size_t lost = 0;
            for (std::size_t i = 0; i < pairs; ++i) {
                if (is_finite(d.at(i))) continue;
                if (std::isfinite(d.at(i).direction.x) || std::isfinite(d.at(i).direction.z)) return false;
                ++lost;
            }
            return lost > 0 && d.may_be_right() && d.say_the_right_density();
        });
    add("square_pulled_in",
        "as many directions as a square's corners have points lie in the horizon itself, or are z itself",
        [](const Directions& d) {
            const double moved = d.share([](const auto& one) {
                return std::abs(one.direction.z) < 1e-7 || std::abs(one.direction.z - 1) < 1e-12;
            });
            return d.are_unit() && std::abs(moved - (1 - std::numbers::pi / 4)) < spread_noise;
        });
    add("whole_steps", "the directions have only some angles around z, or only some from it",
        [](const Directions& d) { return are_spread(d.which) && have_whole_steps(d.shares); });
    add("lifted_to_one", "no direction is more than 45 degrees from z", [](const Directions& d) {
        double least = 1;
        for (std::size_t i = 0; i < pairs; ++i)
            if (is_finite(d.at(i))) least = std::min(least, glm::normalize(d.at(i).direction).z);
        return std::abs(least - std::sqrt(0.5)) < 0.01;
    });
    add("y_is_up", "the directions would be right if y, or x, were the normal", [](const Directions& d) {
        const double below = d.share([](const auto& one) { return one.direction.z < -1e-9; });
        return below > 0.1 && d.may_be_right_around(0) != d.may_be_right_around(1);
    });
    add("below_the_surface", "some directions go into the surface",
        [](const Directions& d) { return d.share([](const auto& one) { return one.direction.z < -1e-9; }) > 0.01; });
    add("not_unit", "lengths are not 1", [](const Directions& d) {
        return d.share([](const auto& one) { return std::abs(glm::length(one.direction) - 1) > 1e-9; }) > 0.1;
    });
    add("same_number_twice", "all directions lie on one curve",
        [](const Directions& d) { return lie_on_a_curve(d.shares); });
    add("pi_by_hand", "the angle goes as a number times a pi of a few digits",
        [](const Directions& d) { return turn_by_a_rounded_pi(d.shares, d.numbers()); });
    add("degrees", "the angle is in degrees",
        [](const Directions& d) { return turn_by_degrees(d.shares, d.numbers()); });
    add("half_turn", "around z there are angles with no direction",
        [](const Directions& d) { return leave_out_turns(d.shares); });
    add("uniform_and_says_so", "all directions are alike, and so says the density", [](const Directions& d) {
        return d.may_be_even_by(cosine_of) && d.say([](double) { return 0.5 / std::numbers::pi; });
    });
    add("uniform_hemisphere", "all directions are alike, and the density is that of a cosine",
        [](const Directions& d) { return have_even_insides_by(d.shares, cosine_of) && d.say_the_right_density(); });
    add("even_angle", "the angle from z is even", [](const Directions& d) {
        return have_even_insides_by(d.shares, [](double inside) {
            return 2 / std::numbers::pi * std::asin(std::sqrt(std::clamp(inside, 0.0, 1.0)));
        });
    });
    add("sqrt_forgotten", "the sine of the angle from z is even", [](const Directions& d) {
        return have_even_insides_by(d.shares, [](double inside) { return std::sqrt(inside); });
    });
    add("cosine_squared", "the cube of the cosine is even", [](const Directions& d) {
        return have_even_insides_by(d.shares, [](double inside) { return std::pow(cosine_of(inside), 3); });
    });
}

inline void add_densities(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, bool (*shows)(const Directions&)) {
        all.push_back(pattern(hint, words, shows));
    };
    static constexpr double pi = std::numbers::pi;
    all.push_back(says("pdf_of_uniform", "the density is 1 / (2 pi)", [](double) { return 0.5 / pi; }));
    all.push_back(says("pdf_without_cosine", "the density is 1 / pi", [](double) { return 1 / pi; }));
    all.push_back(says("pdf_without_pi", "the density is the cosine", [](double cosine) { return cosine; }));
    all.push_back(
        says("pdf_times_two", "the density is twice what is right", [](double cosine) { return 2 * cosine / pi; }));
    const std::string per_angle = "the density has a sine in it";
    all.push_back(
        says("pdf_per_angle", per_angle, [](double cosine) { return cosine * std::sqrt(1 - cosine * cosine) / pi; }));
    all.push_back(
        says("pdf_per_angle", per_angle, [](double cosine) { return 2 * cosine * std::sqrt(1 - cosine * cosine); }));
    const std::string by_sine = "the density is that of the sine, or of its square";
    all.push_back(says("pdf_by_the_sine", by_sine, [](double cosine) { return std::sqrt(1 - cosine * cosine) / pi; }));
    all.push_back(says("pdf_by_the_sine", by_sine, [](double cosine) { return (1 - cosine * cosine) / pi; }));
    const std::string squared = "the density goes with the square of the cosine";
    all.push_back(says("pdf_squared", squared, [](double cosine) { return cosine * cosine / pi; }));
    all.push_back(says("pdf_squared", squared, [](double cosine) { return cosine * cosine; }));
    all.push_back(says("pdf_squared", squared, [](double cosine) { return 1.5 * cosine * cosine / pi; }));
    all.push_back(says("pdf_squared", squared, [](double cosine) { return cosine * cosine / (pi * pi); }));
    all.push_back(says("root", "the density goes with the root of the cosine",
                       [](double cosine) { return std::sqrt(cosine) / pi; }));
    all.push_back(says("complement", "the density goes with 1 - cos", [](double cosine) { return (1 - cosine) / pi; }));
    add("density_at_the_horizon", "near the horizon the density is one and the same, and larger than it should be",
        [](const Directions& d) {
            double least = 0;
            for (std::size_t i = 0; i < pairs; ++i)
                if (is_finite(d.at(i)) && d.at(i).pdf > right_density(d.at(i)) + 1e-12) least = d.at(i).pdf;
            return least > 0 && least < 0.1 && d.are_unit() && d.share([least](const auto& one) {
                return std::abs(one.pdf - std::max(least, right_density(one))) < 1e-12;
            }) == 1;
        });
    add("density_at_the_horizon", "something is added to each density", [](const Directions& d) {
        const double more = d.at(pairs / 3).pdf - right_density(d.at(pairs / 3));
        return more > 1e-12 && more < 0.1 && d.are_unit() &&
               d.share([more](const auto& one) { return std::abs(one.pdf - right_density(one) - more) < 1e-12; }) == 1;
    });
    add("pi_by_hand", "the density is right up to a factor of nearly 1, as by a pi of a few digits",
        [](const Directions& d) {
            const SampledDirection some = d.at(pairs / 3);
            const double factor = some.pdf / right_density(some);
            return d.are_unit() && d.may_be_right() && std::abs(factor - 1) < 1e-3 && std::abs(factor - 1) > 1e-9 &&
                   d.nearly_all([factor](const auto& one) { return agree(one.pdf, factor * right_density(one)); });
        });
    add("factor", "the density is a multiple of what is right", [](const Directions& d) {
        const SampledDirection some = d.at(pairs / 3);
        const double factor = some.pdf / right_density(some);
        return d.are_unit() && d.may_be_right() && !(std::abs(factor - 1) < 1e-6) &&
               d.nearly_all([factor](const auto& one) { return agree(one.pdf, factor * right_density(one)); });
    });
    add("reciprocal", "the density is 1 over what is right", [](const Directions& d) {
        return d.are_unit() && d.may_be_right() &&
               d.nearly_all([](const auto& one) { return agree(one.pdf, 1 / right_density(one)); });
    });
    add("too_near_z", "around z all is even, and directions near z are too frequent", [](const Directions& d) {
        return are_spread(d.which) && d.are_unit() && have_even_turns(d.shares) &&
               mean_inside(d.shares) < 0.5 - spread_noise;
    });
    add("too_near_the_horizon", "around z all is even, and directions near the horizon are too frequent",
        [](const Directions& d) {
            return are_spread(d.which) && d.are_unit() && have_even_turns(d.shares) &&
                   mean_inside(d.shares) > 0.5 + spread_noise;
        });
    add("uneven_turn", "angles from z are right, and some angles around z are more frequent than others",
        [](const Directions& d) {
            return are_spread(d.which) && have_even_insides(d.shares) && !have_even_turns(d.shares);
        });
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    add_ways(all);
    add_densities(all);
    return all;
}

}  // namespace raylab::grading::cosine_lobe
