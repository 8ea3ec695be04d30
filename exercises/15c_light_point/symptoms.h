#pragma once

#include "squashed_cones.h"
#include "symptoms_of_densities.h"

// What wrong answers to this exercise have in common.

namespace raylab::grading::light {

/// How far a point lies before the place where its ray first meets the light: negative behind it. A point that was
/// moved beyond the lit one is on the ray as well.
inline double depth_before(const Points& points, const LightPoint& one) {
    const Vec3d way = one.point - points.given.from, to_center = points.given.center - points.given.from;
    const double sense = dot(way, to_center) < 0 ? -1 : 1;
    const Vec3d ray = sense * glm::normalize(way);
    const double middle = dot(ray, to_center);
    const Vec3d aside = to_center - middle * ray;
    const double half_chord = std::sqrt(std::max(0.0, points.given.radius * points.given.radius - dot(aside, aside)));
    return middle - half_chord - sense * glm::length(way);
}

inline void add_places(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, Pattern shows) {
        all.push_back(pattern(hint, words, shows));
    };
    add("nothing_along_an_axis", "the light lies exactly along x, y or z, and no point is a number",
        [](const Points& p) {
            const Vec3d axis = glm::abs(p.axis());
            return std::max({axis.x, axis.y, axis.z}) == 1 &&
                   p.nearly_all([](const auto& one) { return !std::isfinite(one.point.x); });
        });
    add("nothing_at_the_edge", "points along the light's edge are no numbers, and all others are right",
        [](const Points& p) {
            const double lost = p.share([](const auto& one) { return !std::isfinite(one.point.x); });
            return lost > 0 && lost < 0.05 && p.share([&](const auto& one) {
                return !std::isfinite(one.point.x) || std::abs(p.seen.reach(one.point) - 1) < 1e-6;
            }) == 1;
        });
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
    add("off_the_light", "the points lie on the right rays, all as far before the light, or behind its surface",
        [](const Points& p) {
            const double first = depth_before(p, p.at(pairs / 3));
            const double ratio = first / glm::length(p.at(pairs / 3).point - p.given.from);
            return std::abs(first) > 1e-9 * p.given.radius && p.nearly_all([&](const auto& one) {
                const double depth = depth_before(p, one), way = glm::length(one.point - p.given.from);
                return std::abs(depth - first) < 1e-3 * std::abs(first) ||
                       std::abs(depth - ratio * way) < 1e-3 * std::abs(first);
            });
        });
    add("off_the_light", "all points are as far off the light's surface", [](const Points& p) {
        const double radii = p.seen.reach(p.at(0).point);
        return std::abs(radii - 1) < 0.1 && std::abs(radii - 1) > 1e-6 && p.reach(radii);
    });
    add("axis_not_unit", "the points are even in a cone that is squashed: its axis was no unit vector",
        [](const Points& p) {
            return are_spread(p.given.which) && !have_even_insides(p.shares) && are_even_in_a_squashed_cone(p);
        });
    all.back().allows = [](const WrongAnswer& w) { return !are_spread(arguments(w.question.input).which); };
    // Where the way is along x, y or z, all points may be one, or right.
    all.push_back({"axis_not_unit", "the points are even in a cone that is squashed: its axes are too short",
                   [](const WrongAnswer& w) {
                       const Points p = points_of(w);
                       return are_spread(p.given.which) && !is_along_an_axis(w.question) && are_even_by_short_axes(p);
                   },
                   [](const Case& q) { return are_spread(arguments(q.input).which) && !is_along_an_axis(q); },
                   [](const WrongAnswer& w) { return is_along_an_axis(w.question); }});
    add("disk_through_the_center", "the points lie on a disk through the light's centre", [](const Points& p) {
        return p.nearly_all([&](const auto& one) {
            const double depth = dot(one.point - p.given.center, p.axis());
            return std::abs(depth) < 1e-6 * p.given.radius && p.seen.reach(one.point) < 1 + 1e-6;
        });
    });
    add("at_one_distance", "all points lie in one plane across the way to the light's centre", [](const Points& p) {
        const auto depth = [&](const LightPoint& one) { return dot(one.point - p.given.from, p.axis()); };
        const double first = depth(p.at(0));
        return p.nearly_all([&](const auto& one) { return agree(depth(one), first); });
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

inline bool lie_on_the_far_side(const Points& p) {
    return p.reach(1) && p.nearly_all([&](const auto& one) { return p.seen.side(one.point) < p.sine_max() + 1e-6; });
}

/// Whether the points would be right if the light were turned round: seen, and even as seen.
inline bool are_mirror_images(const Points& p) {
    if (!lie_on_the_far_side(p)) return false;
    std::vector<DrawnShare> shares;
    for (std::size_t i = 0; i < pairs; ++i) {
        const Vec3d image = 2.0 * p.given.center - p.at(i).point;
        if (p.seen.side(image) < p.sine_max() - 1e-4) return false;
        shares.push_back(p.seen.share(image));
    }
    return !are_spread(p.given.which) || have_even_insides(shares);
}

inline void add_sides(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, Pattern shows) {
        all.push_back(pattern(hint, words, shows));
    };
    add("whole_steps", "the points have only some angles around the light's middle, or only some from it",
        [](const Points& p) { return are_spread(p.given.which) && p.reach(1) && have_whole_steps(p.shares); });
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
    add("facing_hemisphere", "the points are all over the half of the sphere that faces the lit point",
        [](const Points& p) {
            double least = 1;
            for (std::size_t i = 0; i < pairs; ++i) least = std::min(least, p.seen.side(p.at(i).point));
            return p.reach(1) && least > -1e-6 && least < std::max(0.5 * p.sine_max(), 0.05);
        });
    add("mirrored", "the points are on the far side, each the mirror image of one that should be there",
        are_mirror_images);
    add("far_side", "nearly all points are on the far side, where the right rays leave the light again",
        [](const Points& p) {
            return lie_on_the_far_side(p) && (!are_spread(p.given.which) || have_even_insides(p.shares));
        });
    add("mirrored", "nearly all points are on the far side", lie_on_the_far_side);
    add("cap_by_area", "the points are even by area on what is seen", [](const Points& p) {
        const double lowest = p.sine_max();
        return p.are_seen() && p.have_even_sides([=](double side) { return (side - lowest) / (1 - lowest); }) &&
               p.share([&](const auto& one) { return agree(one.pdf, p.seen.density()); }) < 0.5;
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
    add("crowd_at_the_edge", "the tangent of the angle from the middle, squared, is even", [](const Points& p) {
        const double most = 1 / (p.cosine_max() * p.cosine_max()) - 1;
        return p.are_seen() && have_even_turns(p.shares) &&
               p.have_even_heights([=](double height) { return (1 / ((1 - height) * (1 - height)) - 1) / most; });
    });
    add("crowd_at_the_edge", "the angle from the middle, squared, is even", [](const Points& p) {
        const double most = std::asin(p.sine_max());
        return p.are_seen() && have_even_turns(p.shares) && p.have_even_heights([=](double height) {
            const double share = 2 * std::asin(std::sqrt(height / 2)) / most;
            return share * share;
        });
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
