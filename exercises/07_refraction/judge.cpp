#include "07_refraction/slot.h"
#include "arguments.h"
#include "critical_sine.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "raylab/geometry/degree.h"
#include "symptoms.h"
#include "words.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace refraction;

constexpr double tolerance = 1e-9;  // of a unit vector

// A ray that arrives at this angle (radians) at a surface of any orientation.
Case make(const std::string& group, Case::Kind kind, double angle, double ior_before, double ior_behind, Dice& dice) {
    const Vec3d normal = dice.direction(), aside = glm::normalize(cross(normal, dice.direction()));
    const Vec3d direction = glm::normalize(std::sin(angle) * aside - std::cos(angle) * normal);
    return {group, kind, {direction.x, direction.y, direction.z, normal.x, normal.y, normal.z, ior_before, ior_behind}};
}

double critical_angle(double ior) { return std::asin(1 / ior); }

Case upright(Dice& dice) {
    const Vec3d normal = dice.direction();
    return {"along the normal",
            Case::Kind::graded,
            {-normal.x, -normal.y, -normal.z, normal.x, normal.y, normal.z, dice.in(1, 2), dice.in(1, 2)}};
}

Case equal(Dice& dice) {
    const double ior = dice.in(1, 2);
    return make("the same matter on both sides", Case::Kind::graded, dice.in(1, 80) * degree, ior, ior, dice);
}

Case into_the_denser(Dice& dice) {
    const double angle = dice.in(3, 87) * degree;
    return make("from air into something denser", Case::Kind::graded, angle, 1, dice.in(1.2, 2.5), dice);
}

Case out_of_the_denser(Dice& dice) {
    const double ior = dice.in(1.2, 2.5), sine = sine_of_what_gets_out(dice);
    return make("out of it, and through", Case::Kind::graded, std::asin(sine / ior), ior, 1, dice);
}

Case kept_inside(Dice& dice) {
    const double ior = dice.in(1.2, 2.5), sine = sine_of_what_is_kept(dice, 0.999 * ior);
    return make("out of it, and all is reflected", Case::Kind::graded, std::asin(sine / ior), ior, 1, dice);
}

Case any_matter(Dice& dice) {
    for (;;) {
        const double angle = dice.in(3, 87) * degree, before = dice.in(1, 2.5), behind = dice.in(1, 2.5);
        if (std::abs(before / behind * std::sin(angle) - 1) > off_one)
            return make("any matter into any other", Case::Kind::graded, angle, before, behind, dice);
    }
}

Case at_the_critical_angle(Dice& dice) {
    const double ior = dice.in(1.2, 2.5);
    return make("within 1e-10 of total internal reflection", Case::Kind::adversarial,
                critical_angle(ior) + dice.in(-1e-10, 1e-10), ior, 1, dice);
}

Case grazing(Dice& dice) {
    return make("a millionth of a degree off the surface", Case::Kind::adversarial, (90 - 1e-6) * degree, 1,
                dice.in(1.2, 2.5), dice);
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const auto& next) {
        for (int i = 0; i < count; ++i) all.push_back(next(dice));
    };
    add(20, upright);
    add(20, equal);
    add(60, into_the_denser);
    add(60, out_of_the_denser);
    add(60, kept_inside);
    add(60, any_matter);
    add(40, at_the_critical_angle);
    add(40, grazing);
    return all;
}

using Wide = glm::vec<3, long double, glm::defaultp>;

long double sine_behind(const Arguments& given) {
    return given.ior_before / static_cast<long double>(given.ior_behind) *
           glm::length(cross(Wide(given.direction), Wide(given.normal)));
}

// The truth, in more digits than a double has: the component along the surface by Snell's law, the rest perpendicular
// to it.
std::optional<Vec3d> truth(const Arguments& given) {
    const long double sine = sine_behind(given);
    if (sine > 1) return std::nullopt;
    const Wide normal(given.normal), along = cross(normal, cross(Wide(given.direction), normal));
    if (glm::length(along) == 0) return -given.normal;
    return Vec3d(sine * glm::normalize(along) - std::sqrt((1 - sine) * (1 + sine)) * normal);
}

std::string answer_words(const std::optional<Vec3d>& direction) {
    return direction ? words(*direction) : "none: total internal reflection";
}

std::optional<Vec3d> said(std::span<const double> answer) {
    return answer[0] != 0 ? std::optional(Vec3d{answer[1], answer[2], answer[3]}) : std::nullopt;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto expected = truth(arguments(question.input)), got = said(answer);
    Judgement result{.expected = answer_words(expected), .got = answer_words(got)};
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); }))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (expected.has_value() == got.has_value() && (!expected || glm::length(*got - *expected) <= tolerance))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    const auto sine = static_cast<double>(sine_behind(given));
    const double angle = std::asin(std::min(1.0, glm::length(cross(given.direction, given.normal)))) / degree;
    const std::string behind =
        sine > 1 ? "no angle has that sine: all is reflected"
                 : fmt::format("that is {:.6g} degrees from the normal's line", std::asin(sine) / degree);
    return fmt::format("direction  {}\nnormal     {}\nindices    {:.10g} before, {:.10g} behind\nIt arrives {:.6g} "
                       "degrees from the normal's line; by Snell's law the sine behind is {:.6g}: {}.",
                       words(given.direction), words(given.normal), given.ior_before, given.ior_behind, angle, sine,
                       behind);
}

// From under water, looking up at a rippled surface: the sky in a round window, and around it the tiles of the bottom.
constexpr int picture_width = 240;
constexpr int picture_height = 180;
constexpr double water = 1.33;

struct EyeRayHit {
    // The direction of the eye ray, its intersection with the surface y = 0, and the ripple's normal, towards the eye.
    Vec3d direction, at, normal;
};

EyeRayHit look_at(int x, int y) {
    const double scale = 2.0 / picture_height;
    const Vec3d direction = glm::normalize(
        Vec3d{(x + 0.5 - 0.5 * picture_width) * scale, 1, (0.5 * picture_height - y - 0.5) * scale + 0.35});
    const Vec3d at = direction / direction.y;  // the eye is 1 m under water
    const double r = std::hypot(at.x - 0.4, at.z - 0.9);
    const double slope = 0.07 * std::sin(16 * r) / (0.5 + r);  // rings around the place where a drop fell
    return {direction, at, glm::normalize(Vec3d{slope * (at.x - 0.4), -1, slope * (at.z - 0.9)})};
}

std::vector<Case> pixel_cases(int x, int y) {
    const auto [direction, at, normal] = look_at(x, y);
    return {{"", Case::Kind::graded, {direction.x, direction.y, direction.z, normal.x, normal.y, normal.z, water, 1}}};
}

bool is_dark_tile(double a, double b) { return (static_cast<int>(std::floor(a) + std::floor(b)) & 1) != 0; }

Pixel shade(int x, int y, std::span<const double> answer) {
    const auto [direction, at, normal] = look_at(x, y);
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); })) return {0.8f, 0, 0.5f};
    const Vec3d mirrored = direction - 2 * dot(direction, normal) * normal;
    const Vec3d way = said(answer).value_or(mirrored);
    if (!(std::abs(way.y) > 1e-6) || (said(answer) && way.y < 0)) return {0.5f, 0, 0};  // nothing is refracted downward
    const Vec3d hit_found = at + way * ((way.y > 0 ? 3 : -2) / way.y);  // an awning above, the bottom below
    if (way.y < 0)
        return is_dark_tile(1.5 * hit_found.x, 1.5 * hit_found.z) ? Pixel{0.02f, 0.16f, 0.2f}
                                                                  : Pixel{0.06f, 0.32f, 0.36f};
    if (std::hypot(hit_found.x - 1, hit_found.z - 1) < 0.8) return {1, 0.9f, 0.5f};
    return is_dark_tile(0.6 * hit_found.x, 0.6 * hit_found.z) ? Pixel{0.35f, 0.6f, 0.9f} : Pixel{0.85f, 0.9f, 0.95f};
}

}  // namespace

Exercise refraction_exercise() {
    return exercise_on(refracted_direction_slot, answer,
                       {.chart = "refraction",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::direction, "the direction", 3},
                                      {Part::Kind::direction, "the normal", 3},
                                      {Part::Kind::number, "ior_before"},
                                      {Part::Kind::number, "ior_behind"}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::flag, "a refracted ray"}, {Part::Kind::vector, "its direction", 3}},
                        .symptoms = symptoms(),
                        .story = story,
                        .picture = {.about = "the sky from under water, through a rippled surface",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
