#include "07c_fresnel/slot.h"
#include "arguments.h"
#include "critical_sine.h"
#include "exercise_list.h"
#include "known.h"
#include "one_number.h"
#include "symptoms.h"
#include "truth.h"
#include "whole_numbers.h"

#include "raylab/geometry/degree.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace fresnel_share;

constexpr double tolerance = 1e-9;  // of a share

Case make(const std::string& group, Case::Kind kind, const Arguments& given) {
    return {group, kind, {given.cosine, given.ior_before, given.ior_behind}};
}

double some_cosine(Dice& dice) { return std::cos(dice.in(2, 88) * degree); }

Arguments along_the_normal(Dice& dice) {
    const double before = dice.in(1, 2.5);
    return {1, before, dice.in(1, 2.5)};
}

// Along the surface nothing gets in, whatever is behind it.
Arguments along_the_surface(Dice& dice) {
    const double before = dice.in(1, 1.4);
    return {0, before, before + dice.in(0.1, 1)};
}

// Out of the denser medium both cosines would be 0 here, and a share 0 / 0, if total reflection were not asked for.
Arguments along_the_surface_out(Dice& dice) {
    const Arguments in = along_the_surface(dice);
    return {0, in.ior_behind, in.ior_before};
}

Arguments the_same_on_both_sides(Dice& dice) {
    const double ior = dice.in(1, 2.5);
    return {some_cosine(dice), ior, ior};
}

Arguments into_the_denser(Dice& dice) {
    const double cosine = some_cosine(dice);
    return {cosine, 1, dice.in(1.2, 2.5)};
}

Arguments out_of_it(Dice& dice) {
    const double ior = dice.in(1.2, 2.5), sine = sine_of_what_gets_out(dice) / ior;
    return {std::sqrt(1 - sine * sine), ior, 1};
}

Arguments kept_inside(Dice& dice) {
    const double ior = dice.in(1.2, 2.5), sine = sine_of_what_is_kept(dice, 0.999 * ior) / ior;
    return {std::sqrt(1 - sine * sine), ior, 1};
}

Arguments any_matter(Dice& dice) {
    for (;;) {
        const double cosine = some_cosine(dice), before = dice.in(1, 2.5);
        const Arguments given{cosine, before, dice.in(1, 2.5)};
        if (std::abs(sine_behind(given) - 1) > off_one) return given;
    }
}

Arguments at_the_critical_angle(Dice& dice) {
    const double ior = dice.in(1.2, 2.5);
    return {std::cos(std::asin(1 / ior) + dice.in(-1e-10, 1e-10)), ior, 1};
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const std::string& group, Arguments (*next)(Dice&),
                         Case::Kind kind = Case::Kind::graded) {
        for (int i = 0; i < count; ++i) all.push_back(make(group, kind, next(dice)));
    };
    add(20, "along the normal", along_the_normal);
    add(20, "along the surface, exactly", along_the_surface);
    add(20, "along the surface, exactly, in the denser medium", along_the_surface_out);
    add(20, "the same matter on both sides", the_same_on_both_sides);
    add(60, "from air into something denser", into_the_denser);
    add(60, "out of it, and through", out_of_it);
    add(40, "out of it, and all is reflected", kept_inside);
    add(60, "any matter into any other", any_matter);
    add(40, "within 1e-10 of total internal reflection", at_the_critical_angle, Case::Kind::adversarial);
    return all;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    return judged_number(truth(arguments(question.input)), answer[0], tolerance);
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    const auto sine = static_cast<double>(sine_behind(given));
    const std::string behind = sine >= 1 ? "no angle has that sine: all is reflected"
                                         : fmt::format("the ray goes on at {:.6g} degrees", std::asin(sine) / degree);
    return fmt::format(
        "cosine     {:.10g}\nindices    {:.10g} before, {:.10g} behind\nThe ray arrives {:.6g} degrees from the "
        "normal; by Snell's law the sine behind is {:.6g}: {}.",
        given.cosine, given.ior_before, given.ior_behind, std::acos(given.cosine) / degree, sine, behind);
}

// A lake to the horizon: tiles on its bottom, a sky of evening light, and of each the share that the function gives it.
constexpr int picture_width = 240, picture_height = 160;
constexpr double water = 1.33;

Vec3d look_at(int x, int y) {
    const double scale = 1.6 / picture_height;
    return glm::normalize(Vec3d{(x + 0.5 - 0.5 * picture_width) * scale, -(y + 1) * scale, -1});
}

std::vector<Case> pixel_cases(int x, int y) { return {make("", Case::Kind::graded, {-look_at(x, y).y, 1, water})}; }

Pixel shade(int x, int y, std::span<const double> answer) {
    if (!std::isfinite(answer[0])) return {0.8f, 0, 0.5f};
    const Vec3d way = look_at(x, y);
    const Vec3d refracted =
        glm::normalize(Vec3d{way.x / water, -std::sqrt(1 - (1 - way.y * way.y) / (water * water)), way.z / water});
    const Vec3d bottom = Vec3d{way.x, 0, way.z} * (1.6 / -way.y) + refracted * (1.5 / -refracted.y);
    const bool dark = (static_cast<int>(std::floor(bottom.x) + std::floor(bottom.z)) & 1) != 0;
    const Vec3d seen = dark ? Vec3d{0.02, 0.10, 0.12} : Vec3d{0.10, 0.38, 0.36};
    const Vec3d sky =
        Vec3d{0.95, 0.45, 0.15} + (Vec3d{0.25, 0.40, 0.75} - Vec3d{0.95, 0.45, 0.15}) * std::min(1.0, -1.5 * way.y);
    const double share = std::clamp(answer[0], -1.0, 2.0);
    const Vec3d color = share * sky + (1 - share) * seen;
    return {cast<float>(color.x), cast<float>(color.y), cast<float>(color.z)};
}

}  // namespace

Exercise fresnel_exercise() {
    return exercise_on(fresnel_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::number, "the cosine"},
                                      {Part::Kind::number, "ior_before"},
                                      {Part::Kind::number, "ior_behind"}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::number, "the share"}},
                        .symptoms = symptoms(),
                        .story = story,
                        .picture = {.about = "a lake to the horizon, the sky in it by the function's shares",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
