#include "chapter_programs.h"
#include "commands.h"
#include "name_list.h"

#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"
#include "raylab/base/outputs.h"
#include "raylab/base/read_json.h"
#include "raylab/base/temporary.h"
#include "raylab/report/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab {

namespace {

using nlohmann::ordered_json;

const CommandLine stability_command_line{
    .program = "raylab stability",
    .about = "Runs the named cases in which methods fail: expected, observed, verdict. Exit code 0: every case is as "
             "expected,\n"
             "expected failures included; 1: some case is not. Without a case it runs all of them.\n"
             "`raylab stability accelerators` compares the answers of all structures: it has its own options.",
    .positionals = {{"CASE", "such as EDGE-SHOT", Positional::Count::any}},
    .options = {{"--list", "", "print the names of the cases and run nothing"},
                {"--quick", "", "fewer rays"},
                {"--seed", "S", "the seed of all random numbers", "1"},
                {"--json", "FILE", "the outcomes, or the list, as JSON; - is standard output"}}};

void refuse_unknown(const std::vector<ChapterProgram>& chapters, const std::vector<std::string>& wanted) {
    std::vector<std::string> known;
    for (const auto& chapter : chapters) known.insert(known.end(), chapter.cases.begin(), chapter.cases.end());
    for (const auto& name : wanted) {
        if (std::ranges::find(known, name) != known.end()) continue;
        throw Error("expected a case (raylab stability --list names them), found " + with_suggestion(name, known));
    }
}

/// The cases of one chapter that are asked for; all of them where none is named.
std::vector<std::string> cases_of(const ChapterProgram& chapter, const std::vector<std::string>& wanted) {
    std::vector<std::string> cases;
    for (const auto& name : chapter.cases)
        if (wanted.empty() || std::ranges::find(wanted, name) != wanted.end()) cases.push_back(name);
    return cases;
}

/// Runs some cases of one chapter and returns their outcomes; the chapter's table goes where this program's output
/// goes.
ordered_json outcomes_of(const ChapterProgram& chapter, const std::vector<std::string>& cases,
                         const Arguments& arguments) {
    const ScratchFolder scratch;
    const auto data = scratch.path() / "outcomes.json";
    std::vector<std::string> options = {"--out", ".", "--json", data.filename(), "--seed", arguments.text("--seed")};
    if (arguments.has("--quick")) options.push_back("--quick");
    for (const auto& name : cases) options.insert(options.end(), {"--case", name});
    const bool silent = arguments.text_if_given("--json") == "-";
    run_for_us(chapter.path, options,
               {.output = silent ? ProcessOptions::Stream::captured : ProcessOptions::Stream::passed_on,
                .folder = scratch.path()});  // so that messages name the files by what follows
    auto outcomes = read_json(data).at("stability");
    for (auto& outcome : outcomes) outcome["chapter"] = chapter.folder;
    return outcomes;
}

}  // namespace

ExitCode stability_command(const std::vector<std::string>& words) {
    if (!words.empty() && words[0] == "accelerators") return stability_accelerators({words.begin() + 1, words.end()});
    const auto arguments = parse(stability_command_line, words);
    seed_if_given(arguments);  // refused here once, not by each chapter
    const auto json = arguments.text_if_given("--json");
    Outputs outputs({.files = arguments.given({"--json"})});
    const auto chapters = listed_chapters();
    const auto& wanted = arguments.all("CASE");
    refuse_unknown(chapters, wanted);
    if (arguments.has("--list")) {
        std::vector<ListedName> names;
        for (const auto& chapter : chapters)
            for (const auto& name : cases_of(chapter, wanted)) names.push_back({name, chapter.folder});
        list_names(names, json, outputs);
        return ExitCode::as_it_should_be;
    }
    auto outcomes = ordered_json::array();
    for (const auto& chapter : chapters) {
        const auto cases = cases_of(chapter, wanted);
        if (cases.empty()) continue;
        for (auto& outcome : outcomes_of(chapter, cases, arguments)) outcomes.push_back(outcome);
    }

    if (json) write_json(json_text(outcomes), outputs[*json]);
    const auto good = std::ranges::count_if(outcomes, [](const auto& one) { return one.at("as_expected") == true; });
    const auto total = static_cast<std::ptrdiff_t>(outcomes.size());
    if (json != "-") outputs.say(fmt::format("\nin all: {} of {} cases as expected\n", good, total));
    outputs.commit();
    return good == total ? ExitCode::as_it_should_be : ExitCode::negative;
}

}  // namespace raylab
