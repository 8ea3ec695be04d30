#include "catch.h"

#include "judging.h"
#include "sanitized.h"

#include "raylab/base/file.h"
#include "raylab/scene/toml/value.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

// Each sentence of a contract (contract.toml of an exercise) is broken by a typical mistake, and the cases that the
// file names catch that mistake: these, and no others.

namespace fs = std::filesystem;
using namespace raylab;
using namespace raylab::grading;
using toml_file::Value;

namespace {

const fs::path source = RAYLAB_SOURCE;

struct Clause {
    std::string says, mistake;
    std::set<std::string> cases;
};

const Value& value_in(const Value& table, const std::string& key) {
    const auto* entry = toml_file::find(std::get<Value::Table>(table.data), key);
    INFO("line " << table.line << ": expected " << key);
    REQUIRE(entry);
    return entry->value;
}

std::vector<Clause> clauses_of(const fs::path& file) {
    const auto root = toml_file::parse(read_file(file), file.string());
    std::vector<Clause> clauses;
    for (const auto& clause : std::get<Value::Array>(value_in(root, "clause").data)) {
        Clause read{.says = std::get<std::string>(value_in(clause, "says").data),
                    .mistake = std::get<std::string>(value_in(clause, "mistake").data),
                    .cases = {}};
        for (const auto& group : std::get<Value::Array>(value_in(clause, "cases").data))
            read.cases.insert(std::get<std::string>(group.data));
        clauses.push_back(std::move(read));
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
        for (const auto& [says, name, cases] : clauses_of(file)) {
            INFO(exercise.folder << ": \"" << says << "\", " << name);
            CHECK(contract.find(in_one_line(says)) != std::string::npos);
            const auto mistake = std::ranges::find(exercise.mistakes, name, &KnownAnswer::name);
            REQUIRE(mistake != exercise.mistakes.end());
            if (is_sanitized) continue;  // another compiler rounds a mistake's sums in another order
            CHECK(groups_that_catch(exercise, mistake->answer) == cases);
        }
    }
}
