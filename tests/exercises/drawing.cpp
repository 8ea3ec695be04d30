#include "catch.h"
#include "of_this_run.h"

#include "drawing.h"
#include "judging.h"

#include "raylab/geometry/vector.h"

#include <algorithm>

using namespace raylab;
using namespace raylab::grading;

namespace {

Pixel color(double red, double green, int blue) { return {cast<float>(red), cast<float>(green), cast<float>(blue)}; }

// An exercise with two cases for each pixel; the function under test returns its input.
Exercise echo() {
    return {.inputs = 1,
            .outputs = 1,
            .picture = {.width = 3,
                        .height = 2,
                        .cases =
                            [](int x, int y) {
                                return std::vector<Case>{{"", {}, {1.0 + x}}, {"", {}, {1.0 + y}}};
                            },
                        .shade = [](int x, int y, auto a) { return color(a[0], a[1], 10 * x + y); }},
            .reference = [](auto in, auto out) { out[0] = in[0]; }};
}

}  // namespace

TEST_CASE("each pixel is shaded by the answers to its own cases") {
    const auto exercise = echo();
    const Image image = drawn(exercise, answers_of(exercise, exercise.reference, cases_of(exercise.picture)));
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) CHECK(image.at(x, y) == color(x + 1, y + 1, 10 * x + y));
}

TEST_CASE("a pixel with an answer missing stays black, and so do all after it") {
    const auto exercise = echo();
    auto answers = answers_of(exercise, exercise.reference, cases_of(exercise.picture));
    answers.resize(9);  // four pixels and a half
    const Image image = drawn(exercise, answers);
    CHECK(image.at(0, 1) == color(1, 2, 1));
    CHECK(image.at(1, 1) == Pixel{});
    CHECK(image.at(2, 1) == Pixel{});
}

TEST_CASE("a picture that is drawn as a whole sees all answers, and is black where one is missing") {
    auto exercise = echo();
    exercise.picture = {.width = 2,
                        .height = 1,
                        .all_cases =
                            [] {
                                return std::vector<Case>{{"", {}, {0.5}}, {"", {}, {0.25}}};
                            },
                        .draw = [](auto a) { return Image(2, 1, color(a[0], a[1], 1)); }};
    const auto answers = answers_of(exercise, exercise.reference, cases_of(exercise.picture));
    CHECK(drawn(exercise, answers).at(1, 0) == color(0.5, 0.25, 1));
    CHECK(drawn(exercise, std::span(answers).first(1)).at(1, 0) == Pixel{});
}

TEST_CASE("every pixel of an exercise's picture asks as many cases, of the exercise's kind") {
    for (const auto& exercise : exercises_of_this_run()) {
        INFO(exercise.folder);
        const auto cases = cases_of(exercise.picture);
        const auto pixels =
            static_cast<std::size_t>(exercise.picture.width) * static_cast<std::size_t>(exercise.picture.height);
        if (!exercise.picture.draw) CHECK(cases.size() == pixels * exercise.picture.cases(0, 0).size());
        for (const auto& question : cases)
            if (question.input.size() != exercise.inputs) FAIL("a case of " << question.input.size() << " doubles");
    }
}

// Those on a boundary (a tangent, an edge, the end of a range) show in no picture.
TEST_CASE("at least six typical mistakes show in the picture") {
    for (std::size_t i = 0; i < exercises().size(); ++i) {
        if (!is_tested_now(i, 4)) continue;
        const auto& exercise = exercises()[i];
        INFO(exercise.folder);
        const auto cases = cases_of(exercise.picture);
        const auto by = [&](const Answer& answer) {
            return drawn(exercise, answers_of(exercise, answer, cases)).pixels();
        };
        const auto truth = by(exercise.reference);
        int shown = 0;
        for (const auto& mistake : exercise.mistakes)
            if (shown < 6 && by(mistake.answer) != truth) ++shown;
        CHECK(shown == 6);
    }
}
