#include "catch.h"

#include "judging.h"
#include "mistake_codes.h"
#include "of_this_run.h"

#include "raylab/base/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

// A hint must be found for a mistake that nobody has written down before. So each mistake is judged as if none of its
// codes were there: by what wrong answers have in common, and by the numbers of the other mistakes. A file's first
// lines say which hints would help: "// hint: a", and perhaps "// or: b, c".

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
    std::string misses = {};  // the codes that got no helpful hint, and what they got
};

// One code, by a judge to whom `known` mistakes are known.
Tally tally_of(const KnownAnswer& code, const Exercise& known) {
    Tally tally;
    const auto helpful = helpful_hints(known, code);
    if (helpful[0] == "depends_on_order") return tally;  // it takes a second process to see that
    for (const auto seed : seeds_of_this_run(10)) {
        const auto cases = known.cases(seed);
        const auto verdict = judge(known, cases, answers_of(known, code.answer, cases));
        if (verdict.answers_right()) continue;  // only its work is wrong
        const bool helps = verdict.hint && std::ranges::find(helpful, *verdict.hint) != helpful.end();
        ++tally.caught;
        tally.helped += helps;
        tally.misled += verdict.hint && !helps;
        if (!helps)
            tally.misses += fmt::format("  {} (seed {}): {} for {}. {}\n", code.name, seed,
                                        verdict.hint.value_or("nothing"), helpful[0], verdict.evidence);
    }
    return tally;
}

enum class Known { others, none };  // which mistakes the judge knows, beside the one that it judges

Tally tally_of(const Exercise& exercise, Known known) {
    Tally all;
    for (const auto& codes : mistakes_of(exercise)) {
        Exercise unknown = exercise;
        std::erase_if(unknown.mistakes, [&](const KnownAnswer& mistake) {
            return known == Known::none || std::ranges::count(codes, mistake.name, &KnownAnswer::name) > 0;
        });
        for (const auto& code : codes) {
            const auto one = tally_of(code, unknown);
            all.caught += one.caught;
            all.helped += one.helped;
            all.misled += one.misled;
            all.misses += one.misses;
        }
    }
    return all;
}

}  // namespace

TEST_CASE("of mistakes that are not known, 85 % get a hint that helps, and none another") {
    if (is_sanitized) return;  // shares are the same there, and known_answers.cpp runs the same judge and symptoms
    for (std::size_t i = 0; i < exercises().size(); ++i) {
        const auto& exercise = exercises()[i];
        if (exercise.symptoms.empty() || !is_tested_now(i, 4)) continue;
        const auto found = tally_of(exercise, Known::others);
        INFO(exercise.folder << ", " << found.caught << " caught:\n" << found.misses);
        CHECK(static_cast<double>(found.helped) >= 0.85 * static_cast<double>(found.caught));
        CHECK(found.misled == 0);
    }
}

TEST_CASE("the table: how many mistakes get a hint that helps, or another", "[.table]") {
    fmt::print("| exercise | caught | helped, misled: itself unknown | no mistake known |\n|---|---|---|---|\n");
    for (const auto& exercise : exercises()) {
        if (exercise.symptoms.empty()) continue;
        const auto one = tally_of(exercise, Known::others);
        const auto all = tally_of(exercise, Known::none);
        fmt::print("| {} | {} | {}, {} | {}, {} |\n", exercise.folder, one.caught, one.helped, one.misled, all.helped,
                   all.misled);
        fmt::print(stderr, "{}{}", one.misses, all.misses);
    }
}
