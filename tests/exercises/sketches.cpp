#include "catch.h"

#include "judging.h"
#include "of_this_run.h"

// The first wrong case of a mistake is drawn with the wrong answer in it.

using namespace raylab;
using namespace raylab::grading;

namespace {

std::string sketched(const Exercise& exercise, const Answer& answer) {
    const auto cases = exercise.cases(1);
    const auto verdict = judge(exercise, cases, answers_of(exercise, answer, cases));
    if (!verdict.first_wrong) return {};  // only its work is wrong
    return to_svg(exercise.sketch(verdict.first_wrong->question, verdict.first_wrong->answer));
}

}  // namespace

TEST_CASE("a sketch of a wrong case shows what is right and what was given, in numbers") {
    std::size_t with_sketch = 0;
    for (const auto& exercise : exercises_of_this_run()) {
        if (!exercise.sketch) continue;
        ++with_sketch;
        for (std::size_t i = 0; i < exercise.mistakes.size(); i += is_sanitized ? 10 : 1) {
            const auto& mistake = exercise.mistakes[i];
            const auto svg = sketched(exercise, mistake.answer);
            if (svg.empty()) continue;
            INFO(exercise.folder << ", " << mistake.name);
            CHECK(svg.find("yours") != std::string::npos);
            CHECK(svg.find("#009e73") != std::string::npos);
            CHECK(svg.find("nan") == std::string::npos);
            CHECK(svg.find("inf") == std::string::npos);
        }
    }
    if (!is_sanitized) CHECK(with_sketch == 23);
}
