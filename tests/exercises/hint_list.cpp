#include "catch.h"

#include "general_symptoms.h"
#include "hints.h"

#include "raylab/base/file.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

// exercises/HINTS.md is made from what the grader knows: each hint's id, what it says, and how it is found.

namespace fs = std::filesystem;
using namespace raylab;
using namespace raylab::grading;

namespace {

using Ways = std::map<std::string, std::set<std::string>>;  // by a hint's id: what leads to it

std::string in_a_cell(std::string text) {
    for (char& c : text)
        if (c == '\n') c = ' ';
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string table(const std::map<std::string, std::string>& hints, const Ways& ways) {
    std::string text = "| id | what it says | found where, in nearly all wrong answers |\n|---|---|---|\n";
    for (const auto& [id, says] : hints) {
        const auto found = ways.find(id);
        text += fmt::format("| `{}` | {} | {} |\n", id, in_a_cell(says),
                            found == ways.end() ? "" : in_a_cell(fmt::format("{}", fmt::join(found->second, "; "))));
    }
    return text;
}

std::string list() {
    std::string text =
        "# All hints\n\n"
        "`raylab check` gives one of these where the evidence supports it, and nothing where it does not; its JSON "
        "names it as `hint_id`. A hint is found by what wrong answers have in common, or where their numbers are those of "
        "a typical mistake. (Made by tests/exercises/hint_list.cpp from the files of hints and the lists of symptoms.)\n\n"
        "## Every exercise\n\n";
    Ways general{{"depends_on_order", {"an answer changes when the cases are asked from last to first"}},
                 {"always_the_same", {"all answers are the same"}},
                 {"one_group", {"one kind of case is wrong, all others are right"}},
                 {"too_much_work", {"each answer is right, and counted work is too much"}}};
    const Ways told_at_once{// its words name a part of one exercise's answer, or an argument
                            {"missing", {"there should be one, and you give none"}},
                            {"nothing_there", {"there should be none, and you give one"}},
                            {"another_question",
                             {"what you give is right for another question: one argument is left out or 1, has the "
                              "other sign, another size or the length 1, or two have changed places"}}};
    general.insert(told_at_once.begin(), told_at_once.end());
    for (const auto& exercise : exercises())
        for (const auto& symptom : general_symptoms(exercise))
            if (!told_at_once.contains(symptom.hint)) general[symptom.hint].insert(symptom.words);
    text += table(read_general_hints(), general);
    for (const auto& exercise : exercises()) {
        Ways ways;
        for (const auto& symptom : exercise.symptoms) ways[symptom.hint].insert(symptom.words);
        for (const auto& mistake : exercise.mistakes) {
            const auto says = fmt::format("the numbers of {}", mistake.name);
            if (!ways.contains(mistake.hint)) ways[mistake.hint].insert(says);
        }
        text += fmt::format("\n## [{}]({}/README.md)\n\n", exercise.folder, exercise.folder) +
                table(read_hints(exercise).mistakes, ways);
    }
    return text;
}

}  // namespace

TEST_CASE("the published list of hints is what the grader knows") {
    const auto published = fs::path(RAYLAB_SOURCE) / "exercises/HINTS.md";
    const auto today = fs::path(RAYLAB_BUILD) / "tests/HINTS.md";
    write_file(today, list());
    INFO("copy " << today.string() << " to " << published.string() << " if that is as it should be");
    CHECK((fs::exists(published) && read_file(published) == list()));
}
