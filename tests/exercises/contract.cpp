#include "catch.h"

#include "judging.h"
#include "sanitized.h"

#include "raylab/base/file.h"
#include "raylab/scene/toml/toml_table.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

// Each sentence of a contract (contract.toml of an exercise) is broken by a typical mistake, and the cases that the
// file names catch that mistake: these, and no others.

namespace fs = std::filesystem;
using namespace raylab;
using namespace raylab::grading;

namespace {

const fs::path source = RAYLAB_SOURCE;

struct Clause {
    std::string says, mistake;
    std::set<std::string> cases;
};

std::vector<Clause> clauses_of(const fs::path& file) {
    const auto root = toml_file::parse(read_file(file), file.string());
    std::vector<Clause> clauses;
    for (const auto& clause : TomlTable(root, file.string()).tables("clause")) {
        const auto cases = clause.texts("cases");
        clauses.push_back({clause.text("says"), clause.text("mistake"), {cases.begin(), cases.end()}});
    }
    return clauses;
}

// A text in one line, without the marks of comments and lists.
std::string in_one_line(const std::string& text) {
    std::istringstream words(text);
    std::string line;
    for (std::string word; words >> word;)
        if (word != "///" && word != "-") line += " " + word;
    return line;
}

// The README, and the headers that the stub includes.
std::string contract_of(const Exercise& exercise) {
    const auto folder = source / "exercises" / exercise.folder;
    auto text = in_one_line(read_file(folder / "README.md"));
    std::istringstream stub(read_file(folder / (exercise.slot + ".cpp")));
    const std::string directive = "#include \"raylab/";
    for (std::string line; std::getline(stub, line);)
        if (line.starts_with(directive))
            text += in_one_line(
                read_file(source / "lib/raylab" / line.substr(directive.size(), line.rfind('"') - directive.size())));
    return text;
}

// Without what searches for a hint, which takes longer than all else.
Exercise without_hints(Exercise exercise) {
    exercise.mistakes.clear();
    exercise.symptoms.clear();
    return exercise;
}

std::set<std::string> groups_that_catch(const Exercise& exercise, const Answer& mistake) {
    std::set<std::string> groups;
    for (const std::uint64_t seed : {1u, 2u}) {
        const auto cases = exercise.cases(seed);
        for (const auto& score : judge(exercise, cases, answers_of(exercise, mistake, cases)).groups)
            if (score.kind == Case::Kind::graded && score.right < score.total) groups.insert(score.group);
    }
    return groups;
}

}  // namespace

TEST_CASE("a sentence of a contract is broken by a mistake that the cases named for it catch, and no others") {
    for (const auto& exercise : exercises()) {
        const auto file = source / "exercises" / exercise.folder / "contract.toml";
        if (!fs::exists(file)) continue;
        const auto contract = contract_of(exercise);
        const auto judged = without_hints(exercise);
        for (const auto& [says, name, cases] : clauses_of(file)) {
            INFO(exercise.folder << ": \"" << says << "\", " << name);
            CHECK(contract.find(in_one_line(says)) != std::string::npos);
            const auto mistake = std::ranges::find(exercise.mistakes, name, &KnownAnswer::name);
            REQUIRE(mistake != exercise.mistakes.end());
            if (is_sanitized) continue;  // another compiler rounds a mistake's sums in another order
            CHECK(groups_that_catch(judged, mistake->answer) == cases);
        }
    }
}
