#include "05c_gouraud_and_phong/slot.h"
#include "arguments.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "questions.h"
#include "sketch.h"
#include "symptoms.h"
#include "words.h"

#include <cmath>

namespace raylab::grading {

namespace {

using namespace mesh_hit;

constexpr double tolerance = 1e-9;  // of a brightness

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const std::string& group, Arguments (*next)(Dice&),
                         Case::Kind kind = Case::Kind::graded) {
        for (int i = 0; i < count; ++i) all.push_back({group, kind, as_input(next(dice))});
    };
    add(50, "a triangle from its front", from_the_front);
    add(40, "a triangle from behind", from_behind);
    add(40, "a highlight between the vertices", with_highlight);
    add(30, "a vertex's normal looks away from the viewer", vertex_looks_away);
    add(20, "the mixed normal looks away from the viewer", mixed_looks_away);
    add(30, "normals far apart", strongly_bent);
    add(20, "on an edge", on_an_edge);
    add(20, "at a vertex", at_a_vertex);
    add(20, "hardly anything is left of the mixed normal", nearly_cancelling);
    add(20, "normals that cancel, in whole numbers", cancelling);
    add(10, "normals that cancel but for rounding", cancels_but_for_rounding, Case::Kind::adversarial);
    return all;
}

std::string in_words(double gouraud, double phong) { return "Gouraud " + words(gouraud) + ", Phong " + words(phong); }

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto expected = truth(of(question));
    Judgement result{.expected = in_words(expected.gouraud, expected.phong), .got = in_words(answer[0], answer[1])};
    if (!std::isfinite(answer[0]) || !std::isfinite(answer[1]))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (std::abs(answer[0] - expected.gouraud) <= tolerance && std::abs(answer[1] - expected.phong) <= tolerance)
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = of(question);
    const auto& [normals, face, u, v, to_viewer] = given.hit;
    const Ingredients made = ingredients(given.hit);
    std::string text = fmt::format("normals    {}\n           {}\n           {}\nface       {}\nu, v       {}, {}\n"
                                   "to viewer  {}\n",
                                   words(normals[0]), words(normals[1]), words(normals[2]), words(face), words(u),
                                   words(v), words(to_viewer));
    text +=
        fmt::format("face . to viewer = {:.6g}: seen from {}. On that side the vertices are {:.6g}, {:.6g} and {:.6g} "
                    "bright.\nThe mixed normal is {:.6g} long.",
                    dot(face, to_viewer), side_of(given.hit) > 0 ? "its front" : "behind", given.model(made.normals[0]),
                    given.model(made.normals[1]), given.model(made.normals[2]), glm::length(mixed(made)));
    return text;
}

std::vector<double> brightness_alone(const Case&, std::span<const double> answer) { return {answer[0], answer[1]}; }

}  // namespace

Exercise gouraud_and_phong_exercise() {
    return exercise_on(gouraud_and_phong_slot, answer,
                       {.chart = "mesh_shading",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::direction, "the first normal", 3},
                                      {Part::Kind::direction, "the second normal", 3},
                                      {Part::Kind::direction, "the third normal", 3},
                                      {Part::Kind::direction, "the face's normal", 3},
                                      {Part::Kind::number, "u"},
                                      {Part::Kind::number, "v"},
                                      {Part::Kind::direction, "the way to the viewer", 3},
                                      {Part::Kind::flag, "the model", 7}},
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .fingerprint = brightness_alone,
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "a ball of 80 triangles, by Gouraud on the left and by Phong on the right",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
