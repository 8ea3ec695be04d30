#include "catch.h"

#include "judging.h"
#include "verdict_text.h"

#include <algorithm>

using namespace raylab::grading;

namespace {

Verdict judged(const Exercise& exercise, const Answer& answer) {
    const auto cases = exercise.cases(1);
    return with_work(judge(exercise, cases, answers_of(exercise, answer, cases)), exercise, cases,
                     work_scores(exercise, answer));
}

// The output of a student's process with this function.
std::vector<double> said(const Exercise& exercise, const Answer& answer) {
    std::vector<double> all;
    const auto largest = max_questions(exercise);
    for (std::size_t i = 0; i < largest.size(); ++i)
        traced(exercise.work[i], static_cast<std::size_t>(largest[i]), [&](auto input, auto output) {
            answer(input, output);
            all.insert(all.end(), output.begin(), output.end());
        });
    return all;
}

const KnownAnswer& known(const std::vector<KnownAnswer>& all, const std::string& name) {
    return *std::ranges::find(all, name, &KnownAnswer::name);
}

bool passes(const std::vector<WorkScore>& scores) { return std::ranges::all_of(scores, &WorkScore::passed); }

}  // namespace

TEST_CASE("right answers cause no more work than the reference") {
    for (const auto& exercise : exercises())
        for (const auto& [name, no_hint, answer] : exercise.right)
            for (const auto& score : work_scores(exercise, answer)) {
                INFO(exercise.folder << ", " << name << ", " << score.rays << ": " << score.yours.value_or(-1) << " "
                                     << score.unit << ", the reference " << score.reference << ", strayed "
                                     << score.strayed);
                CHECK(score.passed());
            }
}

TEST_CASE("where work is counted, a typical mistake answers every case rightly and fails by its work alone") {
    for (const auto& exercise : exercises()) {
        if (exercise.work.empty()) continue;
        INFO(exercise.folder);
        CHECK(std::ranges::any_of(exercise.mistakes, [&](const KnownAnswer& mistake) {
            const auto verdict = judged(exercise, mistake.answer);
            return verdict.answers_right() && !verdict.passed() && verdict.hint == mistake.hint;
        }));
    }
}

TEST_CASE("every task finds a typical mistake") {
    for (const auto& exercise : exercises())
        for (std::size_t task = 0; task < exercise.work.size(); ++task) {
            INFO(exercise.folder << ", " << exercise.work[task].rays);
            CHECK(std::ranges::any_of(exercise.mistakes, [&](const KnownAnswer& mistake) {
                const auto score = work_scores(exercise, mistake.answer)[task];
                return score.strayed == 0 && !score.passed();
            }));
        }
}

TEST_CASE("the judge counts by what a process says: the same as in this one") {
    for (const auto& exercise : exercises()) {
        if (exercise.work.empty()) continue;
        for (const Answer& answer : {exercise.reference, exercise.mistakes.back().answer}) {
            const auto here = work_scores(exercise, answer), there = work_scores(exercise, said(exercise, answer));
            INFO(exercise.folder);
            CHECK(std::ranges::equal(here, there, {}, &WorkScore::yours, &WorkScore::yours));
            CHECK(std::ranges::equal(here, there, {}, &WorkScore::strayed, &WorkScore::strayed));
        }
    }
}

TEST_CASE("answers that are missing, made up or no numbers are no proof of little work") {
    for (const auto& exercise : exercises()) {
        if (exercise.work.empty()) continue;
        INFO(exercise.folder);
        const auto true_words = said(exercise, exercise.reference);
        CHECK(passes(work_scores(exercise, true_words)));
        CHECK_FALSE(passes(work_scores(exercise, std::span<const double>())));
        CHECK_FALSE(passes(work_scores(exercise, std::span(true_words).first(true_words.size() - 1))));
        for (const double word : {0.0, 1.0, -1.0, 1e300, std::nan("")})
            CHECK_FALSE(passes(work_scores(exercise, std::vector<double>(true_words.size(), word))));
    }
}

TEST_CASE("counted work is told with the reference's, and what is allowed, to people and to machines") {
    const auto& boxes = exercise("09");
    const auto slow = judged(boxes, known(boxes.mistakes, "remembers_the_range").answer);
    const auto text = to_text(boxes, slow, read_hints(boxes));
    INFO(text);
    CHECK(text.find("✗  rays of a camera    53.3 boxes a ray, the reference 40.2, at most 44.2 allowed\n") !=
          text.npos);
    CHECK(text.find("must not keep the range") != text.npos);
    CHECK(text.find("graded cases right, 0 of 3 counts of work") != text.npos);
    CHECK(to_json(boxes, slow, {}).find("\"unit\": \"boxes a ray\"") != std::string::npos);
    CHECK(to_json(boxes, slow, {}).find("\"verdict\": \"too_much_work\"") != std::string::npos);

    const auto& grid = exercise("10");
    const auto endless = judged(grid, known(grid.mistakes, "a_billionth_on").answer);
    CHECK(to_text(grid, endless, read_hints(grid)).find("stopped at 10 times the reference's questions") !=
          std::string::npos);
    CHECK(to_json(grid, endless, {}).find("\"yours\": null") != std::string::npos);
}

TEST_CASE("an end while work is counted is told beside wrong answers, to people and to machines") {
    const auto& boxes = exercise("09");
    const auto cases = boxes.cases(1);
    Verdict verdict = judge(boxes, cases, answers_of(boxes, known(boxes.mistakes, "any_slab").answer, cases));
    CHECK_FALSE(verdict.answers_right());
    CHECK(to_json(boxes, verdict, {}).find("\"work_ended\": null") != std::string::npos);
    verdict.work_ended = "killed by signal 11";
    const auto text = to_text(boxes, verdict, read_hints(boxes));
    CHECK(text.find("got  ") != std::string::npos);
    CHECK(text.find("not counted: the function did not come to an end, killed by signal 11") != std::string::npos);
    CHECK(to_json(boxes, verdict, {}).find("\"work_ended\": \"killed by signal 11\"") != std::string::npos);
    CHECK(to_json(boxes, verdict, {}).find("\"verdict\": \"wrong\"") != std::string::npos);
}
