#include "catch.h"

#include "changed_arguments.h"
#include "judging.h"
#include "of_this_run.h"
#include "symptom_search.h"

#include <algorithm>

// Of an argument that is used otherwise than it is meant, the grader says which one it is.

using namespace raylab::grading;

namespace {

// What is said of a function that answers rightly to the case with another number in a place.
std::string said_of(const std::string& name, void (*change)(std::span<double> input)) {
    const auto& asked = exercise(name);
    const auto cases = asked.cases(1);
    const auto answers = answers_of(
        asked,
        [&](std::span<const double> in, std::span<double> out) {
            std::vector<double> other(in.begin(), in.end());
            change(other);
            asked.reference(other, out);
        },
        cases);
    Outcomes outcomes;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (cases[i].kind != Case::Kind::graded) continue;
        const auto answer = std::span(answers).subspan(i * asked.outputs, asked.outputs);
        const bool right = asked.judge(cases[i], answer).outcome == Judgement::Outcome::right;
        (right ? outcomes.right : outcomes.wrong).push_back(i);
    }
    const auto found = find_symptom(asked, changed_argument_symptoms(asked), cases, answers, outcomes);
    return found ? found->evidence : "nothing";
}

}  // namespace

TEST_CASE("an argument that is used otherwise than it is meant is named") {
    using Catch::Matchers::Contains;
    CHECK_THAT(said_of("02", [](auto in) { in[11] *= 2; }), Contains("the radius is twice as large"));
    CHECK_THAT(said_of("03", [](auto in) { std::swap_ranges(in.begin() + 11, in.begin() + 14, in.begin() + 14); }),
               Contains("the vertex b and the vertex c have changed places"));
    CHECK_THAT(said_of("05", [](auto in) { in[9] *= in[9]; }), Contains("the shininess is squared"));
    CHECK_THAT(said_of("07", [](auto in) { std::swap(in[6], in[7]); }),
               Contains("ior_before and ior_behind have changed places"));
    CHECK_THAT(said_of("12", [](auto in) { in[9] = 0; }), Contains("empty_bonus is 0"));
    CHECK_THAT(said_of("13",
                       [](auto in) {
                           for (const int i : {2, 5, 8}) in[i] = 1 / in[i];
                       }),
               Contains("a corner's depth is 1 over it"));
}

TEST_CASE("what no argument explains is not said to be one's") {
    CHECK(said_of("02", [](auto in) { in[11] *= 1.5; }) == "nothing");
    CHECK(said_of("02", [](auto in) { in[8] = -in[8]; }) == "nothing");  // one coordinate of the centre
    CHECK(said_of("05", [](auto in) { in[9] += 1; }) == "nothing");
}

TEST_CASE("the arguments that an exercise names are all numbers of a case, and each may be changed") {
    for (const auto& exercise : exercises_of_this_run()) {
        std::size_t named = 0;
        for (const auto& part : exercise.arguments) named += part.count;
        INFO(exercise.folder);
        CHECK((named == 0 || named == exercise.inputs));
        const auto symptoms = changed_argument_symptoms(exercise);
        CHECK(symptoms.empty() == (named == 0));
        for (const auto seed : seeds_of_this_run(20)) {
            std::size_t changed = 0;
            const auto cases = exercise.cases(seed);
            for (const auto& symptom : symptoms) changed += std::ranges::count_if(cases, symptom.where);
            CHECK(changed >= cases.size() * (named == 0 ? 0 : 1));
        }
    }
}
