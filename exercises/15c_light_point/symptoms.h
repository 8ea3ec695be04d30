#pragma once

#include "point_patterns.h"
#include "seen_light.h"
#include "symptom.h"

#include <algorithm>
#include <array>
#include <functional>

// What wrong answers to this exercise have in common.

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

inline bool is_aslant(const Case& question) {
    const Arguments given = arguments(question.input);
    return glm::normalize(given.center - given.from).z < 0.999;
}

inline void add_places(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, Pattern shows) {
        all.push_back(pattern(hint, words, shows));
    };
    all.push_back(pattern(
        "from_forgotten", "the points would be on the light if the lit point were added to them",
        [](const Points& p) {
            return !p.reach(1) && p.nearly_all([&](const auto& one) {
                return std::abs(p.seen.reach(one.point + p.given.from) - 1) < 1e-6;
            });
        },
        is_elsewhere));
    add("direction_for_point", "what you give as points are of length 1, or a length of 1 from the lit one",
        [](const Points& p) {
            const auto unit = [](const Vec3d& v) { return std::abs(glm::length(v) - 1) < 1e-9; };
            return p.nearly_all([&](const auto& one) { return unit(one.point); }) ||
                   p.nearly_all([&](const auto& one) { return unit(one.point - p.given.from); });
        });
    add("away_from_the_light", "the points lie as far behind the lit point as they should lie before it",
        [](const Points& p) {
            return p.nearly_all(
                [&](const auto& one) { return std::abs(p.seen.reach(2.0 * p.given.from - one.point) - 1) < 1e-6; });
        });
    add("at_one_distance", "all points are equally far from the lit one", [](const Points& p) {
        const double first = glm::length(p.at(0).point - p.given.from);
        return p.nearly_all([&](const auto& one) { return agree(glm::length(one.point - p.given.from), first); });
    });
    add("diameter", "the points lie on a sphere that is twice as large", [](const Points& p) { return p.reach(2); });
    add("disk_through_the_center", "the points lie on a disk through the light's centre", [](const Points& p) {
        return p.nearly_all([&](const auto& one) {
            const double depth = dot(one.point - p.given.center, p.axis());
            return std::abs(depth) < 1e-6 * p.given.radius && p.seen.reach(one.point) < 1 + 1e-6;
        });
    });
    add("middle_of_the_chord", "the points lie where a ray is nearest to the light's centre", [](const Points& p) {
        return p.nearly_all([&](const auto& one) {
            const Vec3d way = one.point - p.given.from, aside = one.point - p.given.center;
            return std::abs(dot(way, aside)) < 1e-6 * glm::length(way) * p.given.radius;
        });
    });
    all.push_back(pattern(
        "axis_forgotten", "the points lie in a cone around z, and the light does not",
        [](const Points& p) {
            return p.nearly_all([&](const auto& one) {
                return std::abs(glm::normalize(one.point - p.given.from).z) > p.cosine_max() - 1e-6;
            });
        },
        is_aslant));
}

inline void add_sides(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, Pattern shows) {
        all.push_back(pattern(hint, words, shows));
    };
    add("same_number_twice", "all points lie on one curve",
        [](const Points& p) { return p.reach(1) && lie_on_a_curve(p.shares); });
    add("pi_by_hand", "the angle goes as a number times a pi of a few digits",
        [](const Points& p) { return turn_by_a_rounded_pi(p.shares, p.numbers()); });
    add("degrees", "the angle is in degrees", [](const Points& p) { return turn_by_degrees(p.shares, p.numbers()); });
    add("half_turn", "around the light's middle there are angles with no point",
        [](const Points& p) { return leave_out_turns(p.shares); });
    add("whole_sphere", "the points are even all over the sphere",
        [](const Points& p) { return !p.are_seen() && p.have_even_sides([](double side) { return (side + 1) / 2; }); });
    add("facing_hemisphere", "the points are even on the half of the sphere that faces the lit point",
        [](const Points& p) { return !p.are_seen() && p.have_even_sides([](double side) { return side; }); });
    add("far_side", "nearly all points are on the far side", [](const Points& p) {
        return p.reach(1) &&
               p.nearly_all([&](const auto& one) { return p.seen.side(one.point) < p.sine_max() + 1e-6; });
    });
    add("cap_by_area", "the points are even by area on what is seen", [](const Points& p) {
        const double lowest = p.sine_max();
        return p.are_seen() && p.have_even_sides([=](double side) { return (side - lowest) / (1 - lowest); }) &&
               p.share([&](const auto& one) { return agree(one.pdf, p.seen.density()); }) < 0.5;
    });
}

inline void add_densities(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, Pattern shows) {
        all.push_back(pattern(hint, words, shows));
    };
    const auto says = [&](const std::string& hint, const std::string& words,
                          double (*density)(const Points&, const LightPoint&)) {
        all.push_back({hint, words, [density](const WrongAnswer& w) {
                           const Points p = points_of(w);
                           return p.may_be_right() && p.say([&](const LightPoint& one) { return density(p, one); });
                       }});
    };
    static constexpr double pi = std::numbers::pi;
    says("solid_angle_for_pdf", "the density is the solid angle",
         [](const Points& p, const LightPoint&) { return 1 / p.seen.density(); });
    says("two_pi_missing", "the density is one over the height of a cap",
         [](const Points& p, const LightPoint&) { return 2 * pi * p.seen.density(); });
    const std::string all_around = "the density is that of all directions, or of those of a hemisphere";
    says("pdf_of_all_directions", all_around, [](const Points&, const LightPoint&) { return 0.25 / pi; });
    says("pdf_of_all_directions", all_around, [](const Points&, const LightPoint&) { return 0.5 / pi; });
    const std::string area = "the density is one per area";
    says("pdf_per_area", area, [](const Points& p, const LightPoint& one) {
        const Vec3d way = one.point - p.given.from, normal = (one.point - p.given.center) / p.given.radius;
        return p.seen.density() * std::abs(dot(glm::normalize(way), normal)) / dot(way, way);
    });
    for (const double share : {4.0, 2.0, 1.0})
        all.push_back({"pdf_per_area", area, [share](const WrongAnswer& w) {
                           const Points p = points_of(w);
                           const double on_sphere = 1 / (share * pi * p.given.radius * p.given.radius);
                           return p.may_be_right() && p.say([&](const LightPoint&) { return on_sphere; });
                       }});
    says("pdf_per_area", area, [](const Points& p, const LightPoint&) {
        return 1 / (2 * pi * p.given.radius * p.given.radius * (1 - p.sine_max()));
    });
    const std::string flat = "the density is that of a small disk across the way, distance^2 / area";
    says("pdf_of_a_flat_light", flat,
         [](const Points& p, const LightPoint&) { return 1 / (pi * p.sine_max() * p.sine_max()); });
    says("pdf_of_a_flat_light", flat, [](const Points& p, const LightPoint& one) {
        const Vec3d way = one.point - p.given.from;
        return dot(way, way) / (pi * p.given.radius * p.given.radius);
    });
    add("outside_the_cone", "nearly all directions lie outside of the light's cone", [](const Points& p) {
        return p.nearly_all([&](const auto& one) {
            return dot(glm::normalize(one.point - p.given.from), p.axis()) < p.cosine_max() + 1e-6;
        });
    });
    add("tangent_for_sine", "the density is that of a cone which is a little too narrow", [](const Points& p) {
        return p.say_cone(std::cos(std::atan(p.sine_max()))) || p.say_cone(std::cos(p.sine_max()));
    });
    add("square_forgotten", "the density is that of a cone whose edge has the cosine sqrt(1 - radius / distance)",
        [](const Points& p) { return p.say_cone(std::sqrt(1 - p.sine_max())); });
    add("cosine_for_sine", "the density is that of a cone whose edge has the cosine radius / distance",
        [](const Points& p) { return p.say_cone(p.sine_max()); });
    add("factor", "the density is a multiple of what is right", [](const Points& p) {
        constexpr std::array factors{0.5, 2.0, 0.25, 4.0, 1 / pi, pi, 0.5 / pi};
        return p.may_be_right() && std::ranges::any_of(factors, [&](double factor) {
                   return p.say([&](const LightPoint&) { return factor * p.seen.density(); });
               });
    });
}

inline void add_spreads(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, Pattern shows) {
        all.push_back(pattern(hint, words, shows));
    };
    add("even_angle", "the angle from the middle is even", [](const Points& p) {
        const double most = std::asin(p.sine_max());
        // 2 sin^2(angle / 2) is 1 minus the cosine.
        return p.have_even_heights([=](double height) { return 2 * std::asin(std::sqrt(height / 2)) / most; });
    });
    add("even_on_the_disk", "the sine of the angle from the middle, squared, is even", [](const Points& p) {
        const double most = p.sine_max() * p.sine_max();
        return have_even_turns(p.shares) &&
               p.have_even_heights([=](double height) { return height * (2 - height) / most; });
    });
    add("crowd_in_the_middle", "around the middle all is even, and directions near it are too frequent",
        [](const Points& p) {
            return are_spread(p.given.which) && p.are_seen() && have_even_turns(p.shares) &&
                   mean_inside(p.shares) < 0.5 - spread_noise;
        });
    add("crowd_at_the_edge", "around the middle all is even, and directions near the edge are too frequent",
        [](const Points& p) {
            return are_spread(p.given.which) && p.are_seen() && have_even_turns(p.shares) &&
                   mean_inside(p.shares) > 0.5 + spread_noise;
        });
    add("uneven_turn", "angles from the middle are right, and some angles around it are more frequent than others",
        [](const Points& p) {
            return are_spread(p.given.which) && p.are_seen() && have_even_insides(p.shares) &&
                   !have_even_turns(p.shares);
        });
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    add_places(all);
    add_sides(all);
    add_densities(all);
    add_spreads(all);
    return all;
}

}  // namespace raylab::grading::light
