#include "02_ray_sphere/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "words.h"

#include "raylab/geometry/oracle/oracle.h"
#include "raylab/image/to_pixel.h"

#include <array>
#include <limits>

namespace raylab::grading {

namespace {

using namespace ray_sphere;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double safe_margin = 1e-6;  // of the discriminant: a thousand million times the rounding error of a double
constexpr double tolerance = 1e-9;    // relative, of t: textbook quadratics lose six digits at these margins, not seven

Case make(const std::string& group, Case::Kind kind, const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const auto& [o, d, range] = ray;
    const auto& c = sphere.center;
    return {group, kind, {o.x, o.y, o.z, d.x, d.y, d.z, range.min, range.max, c.x, c.y, c.z, sphere.radius}};
}

// A sphere somewhere, and a ray from outside aimed at a point `reach` radii from its centre.
Case aimed(Dice& dice, const std::string& group, double reach, Interval<double> range, double length) {
    const SphereOf<double> sphere{as_floats(dice.point(-3, 3)), 0x1p-8 * std::round(dice.in(64, 512))};
    const Vec3d away = dice.direction();
    const Vec3d origin = as_floats(sphere.center + away * (sphere.radius * dice.in(2, 6)));
    const Vec3d side = glm::normalize(cross(away, dice.direction()));
    const Vec3d target = sphere.center + side * (sphere.radius * reach);
    const Vec3d direction = as_floats((target - origin) * (length / glm::length(target - origin)));
    return make(group, Case::Kind::graded, {origin, direction, range}, sphere);
}

Case from_inside(Dice& dice) {
    const SphereOf<double> sphere{as_floats(dice.point(-3, 3)), 0x1p-8 * std::round(dice.in(64, 512))};
    const Vec3d origin = as_floats(sphere.center + dice.direction() * (sphere.radius * dice.in(0, 0.9)));
    return make("inside start", Case::Kind::graded,
                {origin, as_floats(dice.direction() * dice.in(0.5, 2)), {0, infinity}}, sphere);
}

Case behind(Dice& dice) {
    auto question = aimed(dice, "behind the ray", dice.in(0, 0.8), {0, infinity}, 1);
    for (const std::size_t i : {3u, 4u, 5u}) question.input[i] = -question.input[i];
    return question;
}

// A range that leaves out the first intersection, or both.
Case cut(Dice& dice) {
    auto question = aimed(dice, "range ends", dice.in(0, 0.7), {0, infinity}, 1);
    const auto [ray, sphere] = arguments(question.input);
    const double middle = dot(sphere.center - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
    const bool from_middle = dice.in(0, 1) < 0.5;
    question.input[from_middle ? 6 : 7] = from_middle ? middle : middle / 4;
    return question;
}

Case far_away(Dice& dice) {
    const SphereOf<double> sphere{as_floats(dice.point(-1, 1)), 1};
    const Vec3d away = dice.direction();
    const Vec3d origin = as_floats(sphere.center + away * 1e6);
    const Vec3d target = sphere.center + glm::normalize(cross(away, dice.direction())) * dice.in(0.9999, 1.0001);
    return make("a sphere a million radii away, at its rim", Case::Kind::adversarial,
                {origin, as_floats(target - origin), {0, infinity}}, sphere);
}

// A Pythagorean triple makes the tangent exact: from (-20, r, 0) along x, the ray touches the sphere of radius r.
Case tangent(Dice& dice) {
    const double radius = std::round(dice.in(1, 100));
    return make("an exact tangent", Case::Kind::adversarial, {{-20 - radius, radius, 0}, {1, 0, 0}, {0, infinity}},
                {{0, 0, 0}, radius});
}

Case floor_sphere(Dice& dice) {
    const Vec3d up = dice.direction();
    const Vec3d center = as_floats(up * -1e7);
    const Vec3d down = as_floats(-up + 0.5 * glm::normalize(cross(up, dice.direction())));
    return make("a sphere as floor, radius 1e7, from 1 m above", Case::Kind::adversarial,
                {as_floats(up), down, {0, infinity}}, {center, 1e7});
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const auto& next) {
        for (std::size_t added = 0; added < count;) {
            auto question = next(dice);
            const auto [ray, sphere] = arguments(question.input);
            if (question.kind == Case::Kind::graded && oracle::margin(ray, sphere) < safe_margin) continue;
            all.push_back(std::move(question));
            ++added;
        }
    };
    add(60, [](Dice& d) { return aimed(d, "in front, unit direction", d.in(0, 0.95), {0, infinity}, 1); });
    add(40, [](Dice& d) { return aimed(d, "passing by", d.in(1.1, 3), {0, infinity}, 1); });
    add(40, behind);
    add(40, from_inside);
    add(40, [](Dice& d) { return aimed(d, "direction of any length", d.in(0, 0.95), {0, infinity}, d.in(0.1, 20)); });
    add(40, cut);
    add(50, far_away);
    add(50, tangent);
    add(50, floor_sphere);
    return all;
}

std::string hit_words(bool hit, double t) { return hit ? "a hit at t = " + words(t) : "no hit"; }

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto [ray, sphere] = arguments(question.input);
    const auto truth = oracle::intersect(ray, sphere);
    const double t = truth.hit() ? truth.t->nearest() : 0;
    Judgement result{.expected = hit_words(truth.hit(), t)};
    if (!std::isfinite(answer[0]) || !std::isfinite(answer[1])) {
        result.outcome = Judgement::Outcome::nonfinite;
        result.got = std::isfinite(answer[0]) ? "t = " + words(answer[1]) : "no answer";
        return result;
    }
    const bool hit = answer[0] != 0;
    result.got = hit_words(hit, answer[1]);
    const bool close = !truth.hit() || std::abs(answer[1] - t) <= tolerance * std::abs(t);
    if (hit == truth.hit() && close) result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto [ray, sphere] = arguments(question.input);
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction);
    const double middle = -dot(f, ray.direction) / a;
    const double nearest = glm::length(f + middle * ray.direction);
    std::string where = fmt::format("It starts {:.3g} radii from the centre", glm::length(f) / sphere.radius);
    if (nearest > sphere.radius) {
        where += fmt::format(" and passes it at {:.3g} radii: its line misses the sphere.", nearest / sphere.radius);
    } else {
        const double half = std::sqrt((sphere.radius - nearest) * (sphere.radius + nearest) / a);
        where += fmt::format("; its line crosses the sphere at t = {:.6g} and t = {:.6g}, and t in [{}, {}] counts.",
                             middle - half, middle + half, ray.range.min, ray.range.max);
    }
    return fmt::format("sphere     centre {}, radius {}\nray        from {} along {}, t in [{}, {}]\n{}",
                       words(sphere.center), sphere.radius, words(ray.origin), words(ray.direction), ray.range.min,
                       ray.range.max, where);
}

// Three spheres, of which the nearest hit wins, seen by an orthographic camera; each pixel calls the function three
// times.
constexpr std::array<SphereOf<double>, 3> still_life{
    {{{-0.9, 0, -0.5}, 0.9}, {{0.7, -0.3, 0.4}, 0.6}, {{0.4, 0.7, -0.8}, 0.5}}};
constexpr int picture_width = 240;
constexpr int picture_height = 180;

RayOf<double> picture_ray_at(int x, int y) {
    const double scale = 2.6 / picture_height;  // metres for each pixel
    return {{(x + 0.5 - 0.5 * picture_width) * scale, (0.5 * picture_height - y - 0.5) * scale, 5},
            {0, 0, -1},
            {0, infinity}};
}

std::vector<Case> pixel_cases(int x, int y) {
    std::vector<Case> cases;
    for (const auto& sphere : still_life) cases.push_back(make("", Case::Kind::graded, picture_ray_at(x, y), sphere));
    return cases;
}

Pixel shade(int x, int y, std::span<const double> answers) {
    const Pixel background{0.02f, 0.03f, 0.06f};
    std::size_t first = still_life.size();
    double nearest = infinity;
    for (std::size_t i = 0; i < still_life.size(); ++i)
        if (answers[2 * i] != 0 && answers[2 * i + 1] < nearest) {
            nearest = answers[2 * i + 1];
            first = i;
        }
    if (first == still_life.size()) return background;
    const auto ray = picture_ray_at(x, y);
    const Vec3d normal = glm::normalize(ray.origin + nearest * ray.direction - still_life[first].center);
    const Vec3d color = (normal + Vec3d(1)) * 0.5;
    return to_pixel(color);
}

}  // namespace

Exercise ray_sphere_exercise() {
    return exercise_on(nearest_sphere_hit_slot, answer,
                       {.chart = "ray_sphere",
                        .inputs = inputs,
                        .outputs = outputs,
                        .cases = cases,
                        .judge = judge,
                        .story = story,
                        .picture = {.about = "three spheres, coloured by their normals",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
