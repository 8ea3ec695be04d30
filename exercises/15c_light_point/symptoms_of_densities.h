#pragma once

#include "seen_points.h"

#include <array>

// What wrong answers have in common whose density is that of something else.

namespace raylab::grading::light {

/// Whether the density is one over this area, times a factor made of the cosine at which the light is seen and of the
/// squared distance. At the light's very edge, where the cosine is 0, anything may come out.
using PerSteradian = double (*)(double cosine, double squared);
inline bool say_per_area(const Points& p, double area, PerSteradian factor) {
    return p.may_be_right() && p.say([&](const LightPoint& one) {
        const Vec3d way = one.point - p.given.from, normal = (one.point - p.given.center) / p.given.radius;
        const double cosine = std::abs(dot(glm::normalize(way), normal));
        return cosine < 1e-3 ? one.pdf : factor(cosine, dot(way, way)) / area;
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
    // Along the middle 1 - cos has no digits left.
    add("pdf_of_the_sample", "the density is that of a cone whose edge is the point itself", [](const Points& p) {
        return p.may_be_right() && p.share([&](const auto& one) {
            const Vec3d way = glm::normalize(one.point - p.given.from), aside = way - p.axis();
            const double expected = 1 / (pi * dot(aside, aside));  // |a - b|^2 is 2 (1 - cos)
            return std::abs(one.pdf / expected - 1) < 1e-4;
        }) > 0.95;
    });
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
    says("pdf_of_a_flat_light", flat,
         [](const Points& p, const LightPoint&) { return 0.5 / (pi * p.sine_max() * p.sine_max()); });
    says("pdf_of_a_flat_light", flat, [](const Points& p, const LightPoint& one) {
        const Vec3d way = one.point - p.given.from;
        return dot(way, way) / (pi * p.given.radius * p.given.radius);
    });
    // Of half the sphere, of all of it, of its disk, of what is seen; rightly turned, or with a part upside down.
    constexpr std::array<PerSteradian, 4> factors{[](double cosine, double squared) { return squared / cosine; },
                                                  [](double cosine, double squared) { return squared * cosine; },
                                                  [](double, double squared) { return squared; },
                                                  [](double cosine, double squared) { return cosine / squared; }};
    for (const double disks : {2.0, 4.0, 1.0, 0.0})
        for (const PerSteradian factor : factors)
            all.push_back(
                {"pdf_of_points_by_area",
                 "the density is one per area turned into one per steradian, as of points that are even by area",
                 [=](const WrongAnswer& w) {
                     const Points p = points_of(w);
                     const double of_disks = disks > 0 ? disks : 2 * (1 - p.sine_max());
                     return say_per_area(p, of_disks * pi * p.given.radius * p.given.radius, factor);
                 }});
    add("outside_the_cone", "many points are no numbers, as where a ray does not meet the light; the density is right",
        [](const Points& p) {
            const double lost = p.share([](const auto& one) { return !std::isfinite(one.point.x); });
            return lost > 0.05 && lost < 1 && p.say([&](const LightPoint&) { return p.seen.density(); });
        });
    add("outside_the_cone", "nearly all directions lie outside of the light's cone", [](const Points& p) {
        return p.nearly_all([&](const auto& one) {
            return dot(glm::normalize(one.point - p.given.from), p.axis()) < p.cosine_max() + 1e-6;
        });
    });
    add("small_light", "the density is that of a cone in which 1 - cos is half of the sine or the angle squared",
        [](const Points& p) {
            const double angle = std::asin(p.sine_max());
            return p.say_cone(1 - p.sine_max() * p.sine_max() / 2) || p.say_cone(1 - angle * angle / 2);
        });
    add("tangent_for_sine", "the density is that of a cone which is a little too narrow", [](const Points& p) {
        return p.say_cone(std::cos(std::atan(p.sine_max()))) || p.say_cone(std::cos(p.sine_max()));
    });
    add("square_forgotten", "the density is that of a cone whose edge has the cosine sqrt(1 - radius / distance)",
        [](const Points& p) { return p.say_cone(std::sqrt(1 - p.sine_max())); });
    add("cosine_for_sine", "the density is that of a cone whose edge has the cosine radius / distance",
        [](const Points& p) { return p.say_cone(p.sine_max()); });
    add("pi_by_hand", "the density is right up to a factor of nearly 1, as by a pi of a few digits",
        [](const Points& p) {
            const double factor = p.at(0).pdf / p.seen.density();
            return p.may_be_right() && std::abs(factor - 1) < 1e-3 && std::abs(factor - 1) > 1e-9 &&
                   p.say([&](const LightPoint&) { return factor * p.seen.density(); });
        });
    add("factor", "the density is a multiple of what is right", [](const Points& p) {
        constexpr std::array multiples{0.5, 2.0, 0.25, 4.0, 1 / pi, pi, 0.5 / pi};
        return p.may_be_right() && std::ranges::any_of(multiples, [&](double factor) {
                   return p.say([&](const LightPoint&) { return factor * p.seen.density(); });
               });
    });
}

}  // namespace raylab::grading::light
