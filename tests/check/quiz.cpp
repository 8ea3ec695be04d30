#include "catch.h"
#include "says.h"

#include "exercise.h"
#include "quiz.h"
#include "quiz_seal.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <filesystem>
#include <utility>

// Tests of `raylab check NN --quiz`.

namespace fs = std::filesystem;
using namespace raylab;
using namespace raylab::grading;

namespace {

ProcessResult quiz(const std::string& exercise, const std::string& answers) {
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", {"check", exercise, "--quiz"},
                       {.input = answers, .timeout = 60});
}

}  // namespace

TEST_CASE("every chapter with an exercise asks three questions, all judged, and one prediction") {
    for (const auto& exercise : exercises()) {
        INFO(exercise.folder);
        const auto quiz = read_quiz(exercise);
        CHECK(quiz.questions.size() == 3);
        CHECK(!quiz.predictions.empty());
        for (const auto& question : quiz.questions) {
            INFO(question.asks);
            CHECK(question.is_judged());
            CHECK(question.answer.size() > 10);
            const bool takes_the_right_one = is_answer(
                question, question.number ? std::to_string(*question.number) : std::to_string(question.right + 1));
            CHECK(takes_the_right_one);
            CHECK_FALSE(is_answer(question, question.number ? "-77" : "9"));
            CHECK_FALSE(is_answer(question, ""));
        }
    }
}

TEST_CASE("a sealed quiz judges as the open one does, and neither it nor its lesson tells an answer") {
    for (const auto& exercise : exercises()) {
        const fs::path folder = fs::path(RAYLAB_SOURCE) / "exercises" / exercise.folder;
        if (!fs::exists(folder / "quiz.toml")) continue;
        INFO(exercise.folder);
        const auto open = read_quiz(exercise);
        const auto text = sealed_quiz(read_file(folder / "quiz.toml"));
        const auto lesson =
            without_answers(read_file(fs::path(RAYLAB_SOURCE) / "chapters" / exercise.chapter / "README.md"));
        const auto sealed = quiz_in(text, "sealed", lesson);
        CHECK(text.find("\nnumber") == std::string::npos);
        CHECK(text.find("\nright") == std::string::npos);
        REQUIRE(sealed.questions.size() == open.questions.size());
        for (std::size_t i = 0; i < open.questions.size(); ++i) {
            const auto& [one, other] = std::pair(open.questions[i], sealed.questions[i]);
            INFO(one.asks);
            CHECK(other.asks == one.asks);
            CHECK_FALSE(other.number);
            CHECK(lesson.find(one.answer) == std::string::npos);
            CHECK(other.answer == "The quiz of the exercise judges yours.");
            for (const char* typed : {"1", "2", "3", "none", "0", "", "-1"})
                CHECK(is_answer(other, typed) == is_answer(one, typed));
            if (!one.number) continue;
            for (const double factor : {1.0, 1.015, 0.985})
                CHECK(is_answer(other, std::to_string(factor * *one.number)));
            for (const double factor : {1.05, 0.95, 2.0, -1.0})
                CHECK_FALSE(is_answer(other, std::to_string(factor * *one.number)));
        }
    }
}

TEST_CASE("a quiz judges numbers, choices and a prediction, and tells the answer") {
    const auto all_right = quiz("04", "6\n3\nnone\nh\n");
    INFO(all_right.output << all_right.errors);
    CHECK(all_right.code == 0);
    CHECK(says(all_right, "4 of 4 right"));
    CHECK(says(all_right, "Observed just now:"));
    const auto some_wrong = quiz("04", "3\n3\n1\nf\n");
    CHECK(some_wrong.code == 1);
    CHECK(says(some_wrong, "No. 6."));
    CHECK(says(some_wrong, "2 of 4 right"));
}

TEST_CASE("a chart's order is predicted before it is measured") {
    const auto asked = [](const std::string& order) { return quiz("05c", "0.5\n3\n2\nh\n" + order + "\n"); };
    const auto right = asked("3 2 4 1");
    INFO(right.output << right.errors);
    CHECK(right.code == 0);
    CHECK(says(right, "3 questions, 2 to predict"));
    CHECK(says(right, "5 of 5 right"));
    const auto wrong = asked("1, 2, 4, 3");
    CHECK(wrong.code == 1);
    CHECK(says(wrong, "4 of 5 right"));
}

TEST_CASE("an order names every method once, and equal ones in any order") {
    const std::vector<double> errors{0.5, 0.1, 0.5, 0};
    for (const char* typed : {"4 2 1 3", "4 2 3 1", "4, 2, 3, 1", " 4 2 1 3 "}) CHECK(is_order(errors, typed));
    for (const char* typed :
         {"", "4 2 1", "4 2 1 1", "4 2 1 3 2", "1 2 3 4", "4 2 1 5", "0 4 2 1", "4 2 x 3", "-1 4 2 1"})
        CHECK_FALSE(is_order(errors, typed));
}

TEST_CASE("a quiz whose answers end is not passed") {
    const auto ended = quiz("2", "1\n");
    CHECK(ended.code == 1);
    CHECK(says(ended, "1 of 1 right, not all were answered"));
}

TEST_CASE("a lesson's formulas are shown as plain text") {
    CHECK(plain_text("$c < 0$ there, so $t_0 t_1 = c / a$\n   is **negative**") ==
          "c < 0 there, so t_0 t_1 = c / a is negative");
    CHECK(plain_text("$\\rho^{10} \\approx 0.349$, $2 \\cdot \\mathbf{d}$") == "rho^10 ~ 0.349, 2 · d");
}
