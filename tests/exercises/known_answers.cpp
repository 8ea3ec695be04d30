#include "catch.h"

#include "general_symptoms.h"
#include "hints.h"
#include "judging.h"
#include "of_this_run.h"

#include <algorithm>
#include <set>

using namespace raylab::grading;

namespace {

// The numbers of seeds with which answers are judged, over ten runs.
constexpr std::uint64_t seeds_of_reference = 200, seeds_of_right_ones = 20, seeds_of_mistakes = 10;
constexpr std::size_t mistakes_apart =
    is_sanitized ? 10 : 1;  // all mistakes of an exercise take the same way through the judge

Verdict judged(const Exercise& exercise, const Answer& answer, std::uint64_t seed) {
    return verdict_on(exercise, exercise.cases(seed), answer);
}

}  // namespace

TEST_CASE("the reference passes on every seed") {
    for (const auto& exercise : exercises_of_this_run())
        for (const auto seed : seeds_of_this_run(seeds_of_reference)) {
            const auto verdict = judged(exercise, exercise.reference, seed);
            INFO(exercise.folder << ", seed " << seed << ": " << verdict.right << " of " << verdict.total);
            CHECK(verdict.passed());
        }
}

TEST_CASE("no ray that passes by the sphere hits it, on any seed", "[long]") {
    const auto& spheres = exercise("02");
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        auto cases = spheres.cases(seed);
        std::erase_if(cases, [](const Case& question) { return question.group != "passing by"; });
        const auto answers = answers_of(spheres, spheres.reference, cases);
        for (std::size_t i = 0; i < answers.size(); i += spheres.outputs) {
            INFO("seed " << seed << ", " << spheres.story(cases[i / spheres.outputs]));
            CHECK(answers[i] == 0);
        }
    }
}

TEST_CASE("right answers written differently pass on every seed") {
    for (const auto& exercise : exercises_of_this_run()) {
        CHECK(exercise.right.size() >= (exercise.symptoms.empty() ? 3 : 5));
        for (const auto& [name, no_hint, answer] : exercise.right)
            for (const auto seed : seeds_of_this_run(seeds_of_right_ones)) {
                const auto verdict = judged(exercise, answer, seed);
                INFO(exercise.folder << ", " << name << ", seed " << seed);
                if (verdict.first_wrong)
                    UNSCOPED_INFO(verdict.first_wrong->story << "\nexpected " << verdict.first_wrong->expected
                                                             << "\ngot " << verdict.first_wrong->got);
                CHECK(verdict.passed());
            }
    }
}

TEST_CASE("every typical mistake fails, with the hint meant for it") {
    for (const auto& exercise : exercises_of_this_run()) {
        CHECK(exercise.mistakes.size() >= (exercise.symptoms.empty() ? 14 : 15));
        for (std::size_t i = 0; i < exercise.mistakes.size(); i += mistakes_apart) {
            const auto& [name, hint, answer] = exercise.mistakes[i];
            for (const auto seed : seeds_of_this_run(seeds_of_mistakes)) {
                const auto verdict = judged(exercise, answer, seed);
                INFO(exercise.folder << ", " << name << ", seed " << seed);
                CHECK_FALSE(verdict.passed());
                REQUIRE(verdict.hint);
                CHECK(*verdict.hint == hint);
            }
        }
    }
}

TEST_CASE("every mistake and symptom has a hint, every hint one of them, and help comes in three levels") {
    const auto general = read_general_hints();
    std::set<std::string> used{"depends_on_order", "always_the_same", "one_group", "too_much_work"};
    for (const auto& exercise : exercises()) {
        INFO(exercise.folder);
        const auto hints = read_hints(exercise);
        CHECK(hints.levels.size() == 3);
        std::set<std::string> with_hint, known;
        for (const auto& [name, text] : hints.mistakes) with_hint.insert(name);
        for (const auto& mistake : exercise.mistakes) known.insert(mistake.hint);
        for (const auto& symptom : exercise.symptoms) {
            known.insert(symptom.hint);
            if (general.contains(symptom.hint)) used.insert(symptom.hint);
        }
        std::erase_if(known,
                      [&](const std::string& hint) { return general.contains(hint) && !with_hint.contains(hint); });
        CHECK(with_hint == known);
        for (const auto& symptom : general_symptoms(exercise)) used.insert(symptom.hint);
    }
    std::set<std::string> of_all;
    for (const auto& [name, text] : general) of_all.insert(name);
    CHECK(of_all == used);
}

TEST_CASE("the same seed asks the same questions, another seed others") {
    for (const auto& exercise : exercises_of_this_run()) {
        const auto first = exercise.cases(7);
        const auto again = exercise.cases(7);
        CHECK(std::ranges::equal(first, again, {}, &Case::input, &Case::input));
        CHECK_FALSE(std::ranges::equal(first, exercise.cases(8), {}, &Case::input, &Case::input));
    }
}

TEST_CASE("an answer that depends on what was asked before is wrong, and told as that") {
    for (const auto& exercise : exercises_of_this_run()) {
        const auto cases = exercise.cases(1);
        const auto right = answers_of(exercise, exercise.reference, cases);
        CHECK(judge(exercise, cases, right, right).answers_right());
        auto again = right;  // as of a function that is wrong from the second call on
        std::fill(again.begin(), again.end() - static_cast<std::ptrdiff_t>(exercise.outputs), -7.5);
        const auto verdict = judge(exercise, cases, right, again);
        INFO(exercise.folder << ": " << verdict.evidence);
        CHECK_FALSE(verdict.answers_right());
        CHECK(verdict.hint == "depends_on_order");
    }
}

// A random generator of one's own gives points that are spread as they should be, and others each time.
TEST_CASE("two right answers to the same question are wrong if they differ") {
    const auto& lens = exercise("15");
    const auto cases = lens.cases(1);
    const auto first = answers_of(lens, lens.reference, cases);
    for (const auto& other : lens.right) {
        const auto again = answers_of(lens, other.answer, cases);
        INFO(other.name);
        CHECK(judge(lens, cases, again).answers_right());
        if (agree(first, again)) continue;  // another way to compute the same points
        const auto verdict = judge(lens, cases, first, again);
        CHECK(verdict.right == 0);
        CHECK(verdict.hint == "depends_on_order");
    }
}

TEST_CASE("answers of a float's precision are told as such") {
    for (const char* name : {"05b", "07c", "12", "13"}) {
        const auto& asked = exercise(name);
        const auto verdict = judged(
            asked,
            [&](auto in, auto out) {
                asked.reference(in, out);
                for (double& number : out) number = static_cast<float>(number);
            },
            1);
        INFO(name << ": " << verdict.right << " of " << verdict.total << ", " << verdict.evidence);
        CHECK(verdict.hint == "few_digits");
    }
}

TEST_CASE("an answer that is not a number is never right", "[long]") {
    for (const auto& exercise : exercises_of_this_run()) {
        const auto verdict = judged(
            exercise, [](auto, auto out) { std::ranges::fill(out, std::nan("")); }, 1);
        INFO(exercise.folder);
        CHECK(verdict.right == 0);
    }
}

TEST_CASE("answers that are missing count as wrong") {
    for (const auto& exercise : exercises_of_this_run()) {
        const auto cases = exercise.cases(1);
        auto answers = answers_of(exercise, exercise.reference, cases);
        answers.resize(10 * exercise.outputs);
        CHECK(judge(exercise, cases, answers).right <= 10);
    }
}
