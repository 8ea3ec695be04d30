#pragma once

#include "point_patterns.h"
#include "seen_light.h"
#include "symptom.h"

#include <algorithm>
#include <functional>

// The points of a wrong answer, and what may be asked of them.

namespace raylab::grading::light {

/// The points of a wrong answer, as they are seen.
struct Points {
    std::span<const double> out;
    Arguments given;
    SeenLight seen = SeenLight(given);
    std::vector<DrawnShare> shares = seen.shares(out);

    LightPoint at(std::size_t i) const { return chosen(out, i); }
    std::vector<NumberPair> numbers() const { return number_pairs(given.which); }
    double sine_max() const { return seen.relative_radius(); }
    double cosine_max() const { return std::sqrt(1 - sine_max() * sine_max()); }
    Vec3d axis() const { return glm::normalize(given.center - given.from); }

    template <class Holds>
    double share(const Holds& holds) const {
        std::size_t some = 0;
        for (std::size_t i = 0; i < pairs; ++i) some += holds(at(i));
        return static_cast<double>(some) / static_cast<double>(pairs);
    }
    template <class Holds>
    bool nearly_all(const Holds& holds) const {
        return share(holds) > 0.99;
    }

    /// Whether the points' distances from the light's centre are so many radii.
    bool reach(double radii) const {
        return nearly_all([&](const auto& one) { return std::abs(seen.reach(one.point) - radii) < 1e-6 * radii; });
    }
    /// Whether law(cosine of the way to the lit point at the light's centre) is even; a grid is too coarse to tell.
    bool have_even_sides(const std::function<double(double)>& law) const {
        if (!reach(1)) return false;
        if (!are_spread(given.which)) return true;
        std::vector<double> numbers;
        for (std::size_t i = 0; i < pairs; ++i) numbers.push_back(law(seen.side(at(i).point)));
        return are_even(std::move(numbers));
    }
    bool are_seen() const {
        return reach(1) && nearly_all([&](const auto& one) { return seen.side(one.point) > sine_max() - 1e-4; });
    }
    /// Whether all is right but the density; a grid is too coarse to tell.
    bool may_be_right() const { return are_seen() && (!are_spread(given.which) || have_even_insides(shares)); }
    /// Whether law(share of the solid angle from the middle), times the solid angle over 2 pi, is even.
    bool have_even_heights(const std::function<double(double height)>& law) const {
        std::vector<double> numbers;
        for (const auto& point : shares) numbers.push_back(law(point.inside * (1 - cosine_max())));
        return are_spread(given.which) && are_even(std::move(numbers));
    }
    bool say(const std::function<double(const LightPoint&)>& density) const {
        return nearly_all([&](const auto& one) { return agree(one.pdf, density(one)); });
    }
    /// The density in a cone whose cosine at the edge is this one.
    bool say_cone(double cosine) const {
        return say([&](const LightPoint&) { return 0.5 / std::numbers::pi / (1 - cosine); });
    }
};

inline Points points_of(const WrongAnswer& wrong) { return {wrong.given, arguments(wrong.question.input)}; }

using Pattern = bool (*)(const Points&);

inline Symptom pattern(const std::string& hint, const std::string& words, Pattern shows,
                       std::function<bool(const Case&)> where = {}) {
    return {hint, words, [shows](const WrongAnswer& w) { return shows(points_of(w)); }, std::move(where)};
}

inline bool is_elsewhere(const Case& question) { return glm::length(arguments(question.input).from) > 0; }

/// Whether the way to the light is along x, y or z.
inline bool is_along_an_axis(const Case& question) {
    const Arguments given = arguments(question.input);
    const Vec3d axis = glm::abs(glm::normalize(given.center - given.from));
    return std::max({axis.x, axis.y, axis.z}) > 1 - 1e-9;
}

inline bool is_aslant(const Case& question) {
    const Arguments given = arguments(question.input);
    return glm::normalize(given.center - given.from).z < 0.999;
}

}  // namespace raylab::grading::light
