#include "05b_local_color/slot.h"
#include "arguments.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "questions.h"
#include "sketch.h"
#include "symptoms.h"
#include "words.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace local;

constexpr double tolerance = 1e-9;  // of the colour's brightest channel, or of 1

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const std::string& group, const auto& next) {
        for (int i = 0; i < count; ++i) all.push_back({group, Case::Kind::graded, as_input(next(dice))});
    };
    add(60, "two lights before the surface", two_lights);
    add(40, "one light before the surface, one behind it", one_behind);
    add(20, "both lights behind the surface", both_behind);
    add(30, "one light", one_light);
    add(20, "no light at all", no_light);
    add(40, "lights that do not fall off", steady_lights);
    add(30, "the viewer stands more than a right angle from the mirror direction", far_from_mirror);
    add(20, "brighter than white", bright_lights);
    add(20, "a light in the plane of the surface, in whole numbers", light_in_plane);
    for (int i = 0; i < 20; ++i)
        all.push_back({"a light on the horizon", Case::Kind::adversarial, as_input(on_horizon(dice))});
    return all;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const Vec3d expected = truth(arguments(question.input)), got{answer[0], answer[1], answer[2]};
    Judgement result{.expected = words(expected), .got = words(got)};
    const double size = std::max({1.0, expected.x, expected.y, expected.z});
    if (!std::ranges::all_of(answer, [](double x) { return std::isfinite(x); }))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (glm::length(got - expected) <= tolerance * size)
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    const auto& s = given.surface;
    std::string text = fmt::format(
        "normal     {}\nto viewer  {}\nunlit      {}\ndiffuse    {}\nspecular   {}, shininess {}", words(s.normal),
        words(s.to_viewer), words(s.unlit), words(s.diffuse), words(s.specular), words(s.shininess));
    if (given.lights.empty()) text += "\nNo light reaches the point.";
    for (const IncidentLight& light : given.lights) {
        const SeenLight seen = seen_light(s, light);
        text += fmt::format(
            "\na light    along {}, colour {}, attenuation {}\n           {:.6g} far: divided by {:.6g}; N.L = "
            "{:.6g}{}",
            words(light.way), words(light.color), words(light.attenuation), seen.distance, seen.falls, seen.incline,
            seen.incline > 0
                ? fmt::format(", R.V = {:.6g}: it brings {}", seen.mirrored, words(right_share(s, light, seen)))
                : ": not before the surface");
    }
    return text;
}

}  // namespace

Exercise local_color_exercise() {
    return exercise_on(local_color_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::direction, "the normal", 3},
                                      {Part::Kind::direction, "the way to the viewer", 3},
                                      {Part::Kind::vector, "the unlit colour", 3},
                                      {Part::Kind::vector, "the diffuse colour", 3},
                                      {Part::Kind::vector, "the specular colour", 3},
                                      {Part::Kind::number, "the shininess"},
                                      {Part::Kind::indices, "how many lights", 1},
                                      {Part::Kind::direction, "the way to a light", 3},
                                      {Part::Kind::vector, "a light's colour", 3},
                                      {Part::Kind::vector, "a light's attenuation", 3},
                                      {Part::Kind::direction, "the way to a light", 3},
                                      {Part::Kind::vector, "a light's colour", 3},
                                      {Part::Kind::vector, "a light's attenuation", 3}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::vector, "the colour", 3}},
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "three balls in a warm light that falls off and a cold one that does not",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
