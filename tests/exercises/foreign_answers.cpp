#include "catch.h"

#include "judging.h"
#include "of_this_run.h"

#include "raylab/base/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

// A hint must be found for a mistake that nobody has written down before. So each mistake is judged as if its file were
// not there: by what wrong answers have in common, and by the numbers of the others. Its first lines say which hints
// would help: "// hint: a", and perhaps "// or: b, c".

using namespace raylab;
using namespace raylab::grading;

namespace {

std::vector<std::string> helpful_hints(const Exercise& exercise, const KnownAnswer& mistake) {
    std::istringstream lines(
        read_file(std::string(RAYLAB_SOURCE) + "/exercises/" + exercise.folder + "/mistakes/" + mistake.name + ".cpp"));
    std::string first, second;
    std::getline(lines, first);
    std::getline(lines, second);
    std::vector<std::string> hints{mistake.hint};
    if (!second.starts_with("// or: ")) return hints;
    std::istringstream others(second.substr(7));
    for (std::string hint; others >> hint;)
        hints.push_back(hint.ends_with(',') ? hint.substr(0, hint.size() - 1) : hint);
    return hints;
}

struct Tally {
    std::size_t caught = 0, helped = 0, misled = 0;
    std::string misses;  // the mistakes that got no helpful hint, and what they got
};

// With only those known mistakes that keep(name, the name of the one judged) lets stay.
template <class Keep>
Tally tally(const Exercise& exercise, const Keep& keep) {
    Tally tally;
    for (const auto& mistake : exercise.mistakes) {
        Exercise unknown = exercise;
        std::erase_if(unknown.mistakes, [&](const KnownAnswer& known) { return !keep(known.name, mistake.name); });
        const auto helpful = helpful_hints(exercise, mistake);
        if (helpful[0] == "depends_on_order") continue;  // it takes a second process to see that
        for (const auto seed : seeds_of_this_run(10)) {
            const auto cases = exercise.cases(seed);
            const auto verdict = judge(unknown, cases, answers_of(exercise, mistake.answer, cases));
            if (verdict.answers_right()) continue;  // only its work is wrong
            const bool helps = verdict.hint && std::ranges::find(helpful, *verdict.hint) != helpful.end();
            ++tally.caught;
            tally.helped += helps;
            tally.misled += verdict.hint && !helps;
            if (!helps)
                tally.misses += fmt::format("  {} (seed {}): {} for {}. {}\n", mistake.name, seed,
                                            verdict.hint.value_or("nothing"), helpful[0], verdict.evidence);
        }
    }
    return tally;
}

}  // namespace

TEST_CASE("of mistakes that are not known, 85 % get a hint that helps, and none another") {
    if (is_sanitized) return;  // shares are the same there, and known_answers.cpp runs the same judge and symptoms
    for (std::size_t i = 0; i < exercises().size(); ++i) {
        const auto& exercise = exercises()[i];
        if (exercise.symptoms.empty() || !is_tested_now(i, 4)) continue;
        const auto found = tally(exercise, [](const auto& known, const auto& judged) { return known != judged; });
        INFO(exercise.folder << ", " << found.caught << " caught:\n" << found.misses);
        CHECK(static_cast<double>(found.helped) >= 0.85 * static_cast<double>(found.caught));
        CHECK(found.misled == 0);
    }
}

TEST_CASE("the table: how many mistakes get a hint that helps, or another", "[.table]") {
    fmt::print("| exercise | caught | helped, misled: itself unknown | no mistake known |\n|---|---|---|---|\n");
    for (const auto& exercise : exercises()) {
        if (exercise.symptoms.empty()) continue;
        const auto one = tally(exercise, [](const auto& known, const auto& judged) { return known != judged; });
        const auto all = tally(exercise, [](const auto&, const auto&) { return false; });
        fmt::print("| {} | {} | {}, {} | {}, {} |\n", exercise.folder, one.caught, one.helped, one.misled, all.helped,
                   all.misled);
        fmt::print(stderr, "{}{}", one.misses, all.misses);
    }
}
