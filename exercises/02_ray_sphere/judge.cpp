#include "02_ray_sphere/slot.h"
#include "arguments.h"
#include "boundary.h"
#include "cases.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "symptoms.h"
#include "words.h"

#include "raylab/geometry/oracle/oracle.h"
#include "raylab/image/to_pixel.h"

#include <array>

namespace raylab::grading {

namespace {

using namespace ray_sphere;

constexpr double safe_margin = 1e-6;  // of the discriminant: a thousand million times the rounding error of a double
constexpr double tolerance = 1e-9;    // relative, of t: textbook quadratics lose six digits at these margins, not seven

Case make(const std::string& group, Case::Kind kind, const Arguments& given) { return {group, kind, as_input(given)}; }

Arguments far_away(Dice& dice) {
    const SphereOf<double> sphere{as_floats(dice.point(-1, 1)), 1};
    const Vec3d away = dice.direction();
    const Vec3d origin = as_floats(sphere.center + away * 1e6);
    const Vec3d target = sphere.center + glm::normalize(cross(away, dice.direction())) * dice.in(0.9999, 1.0001);
    return {{origin, as_floats(target - origin), {0, infinity}}, sphere};
}

// From (-20, r, 0) along x, the ray touches the sphere of radius r.
Arguments tangent(Dice& dice) {
    const double radius = std::round(dice.in(1, 100));
    return {{{-20 - radius, radius, 0}, {1, 0, 0}, {0, infinity}}, {{0, 0, 0}, radius}};
}

Arguments floor_sphere(Dice& dice) {
    const Vec3d up = dice.direction();
    const Vec3d down = as_floats(-up + 0.5 * glm::normalize(cross(up, dice.direction())));
    return {{as_floats(up), down, {0, infinity}}, {as_floats(up * -1e7), 1e7}};
}

using Next = Arguments (*)(Dice&);

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto with_margin = [&](std::size_t count, const std::string& group, Next next) {
        for (std::size_t added = 0; added < count;) {
            const Arguments given = next(dice);
            if (oracle::margin(given.ray, given.sphere) < safe_margin) continue;
            all.push_back(make(group, Case::Kind::graded, given));
            ++added;
        }
    };
    const auto as_they_are = [&](std::size_t count, const std::string& group, Case::Kind kind, Next next) {
        for (std::size_t i = 0; i < count; ++i) all.push_back(make(group, kind, next(dice)));
    };
    with_margin(60, "in front, unit direction", in_front);
    with_margin(40, "passing by", passing_by);
    with_margin(40, "behind the ray", behind);
    with_margin(40, "inside start", from_inside);
    with_margin(40, "direction of any length", of_any_length);
    with_margin(40, "range ends", cut_unit);
    with_margin(20, "range ends between the crossings", ends_inside_unit);
    with_margin(30, "range ends, direction of any length", cut_any_length);
    with_margin(20, "range ends between the crossings, direction of any length", ends_inside_any_length);
    with_margin(20, "range that begins before the start", begins_before_start);
    with_margin(20, "a few hundredths of a millimetre", tiny);
    with_margin(20, "hundreds of radii away", far_off);
    with_margin(20, "a large sphere underfoot", underfoot);
    as_they_are(20, "a tangent, in whole numbers", Case::Kind::graded, touching);
    as_they_are(20, "a range that ends at a hit, in whole numbers", Case::Kind::graded, ends_at_hit);
    as_they_are(50, "a sphere a million radii away, at its rim", Case::Kind::adversarial, far_away);
    as_they_are(50, "an exact tangent", Case::Kind::adversarial, tangent);
    as_they_are(50, "a sphere as floor, radius 1e7, from 1 m above", Case::Kind::adversarial, floor_sphere);
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
    for (const auto& sphere : still_life) cases.push_back(make("", Case::Kind::graded, {picture_ray_at(x, y), sphere}));
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
                        .arguments = {{Part::Kind::vector, "the origin", 3},
                                      {Part::Kind::direction, "the direction", 3},
                                      {Part::Kind::number, "range.min"},
                                      {Part::Kind::number, "range.max"},
                                      {Part::Kind::vector, "the centre", 3},
                                      {Part::Kind::number, "the radius"}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::flag, "a hit"}, {Part::Kind::number, "t"}},
                        .symptoms = symptoms(),
                        .story = story,
                        .picture = {.about = "three spheres, coloured by their normals",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
