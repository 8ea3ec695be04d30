#include "chapter_programs.h"
#include "commands.h"
#include "name_list.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/nearest_name.h"
#include "raylab/base/outputs.h"
#include "raylab/base/temporary.h"
#include "raylab/report/json_text.h"

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

const CommandLine chart_command_line{
    .program = "raylab chart",
    .about =
        "Measures speed against accuracy of all methods of one question, prints the answer with a line for each method, and\n"
        "writes QUESTION.svg .png .csv .json. Without a question it prints the list of questions.",
    .positionals = {{"QUESTION", "such as ray_triangle", Positional::Count::optional}},
    .options = {{"-o,--out", "DIR", "the folder for the files", "."},
                {"--quick", "", "fewer queries"},
                {"--rows", "", "print every measurement, and not one line a method"},
                {"--seed", "S", "the seed of all random numbers", "1"},
                {"--json", "FILE", "write only the data, or the list, to this file; - is standard output"}}};

std::vector<ListedName> all_questions(const std::vector<ChapterProgram>& chapters) {
    std::vector<ListedName> questions;
    for (const auto& chapter : chapters)
        for (const auto& question : chapter.questions) questions.push_back({question, chapter.folder});
    return questions;
}

const ChapterProgram& chapter_that_asks(const std::vector<ChapterProgram>& chapters, const std::string& question) {
    std::vector<std::string> known;
    for (const auto& chapter : chapters) {
        if (std::ranges::find(chapter.questions, question) != chapter.questions.end()) return chapter;
        known.insert(known.end(), chapter.questions.begin(), chapter.questions.end());
    }
    throw Error("expected a question (raylab chart lists them), found " + with_suggestion(question, known));
}

std::vector<fs::path> chart_files(const fs::path& folder, const std::string& question) {
    std::vector<fs::path> files;
    for (const char* extension : {".svg", ".png", ".csv", ".json"}) files.push_back(folder / (question + extension));
    return files;
}

}  // namespace

ExitCode chart_command(const std::vector<std::string>& words) {
    const auto arguments = parse(chart_command_line, words);
    const auto chapters = listed_chapters();
    const auto json = arguments.text_if_given("--json");
    if (!arguments.has("QUESTION")) {
        Outputs outputs({.files = arguments.given({"--json"})});
        list_names(all_questions(chapters), json, outputs);
        return ExitCode::as_it_should_be;
    }
    const auto question = arguments.text("QUESTION");
    const auto& chapter = chapter_that_asks(chapters, question);
    const fs::path folder = arguments.text("--out");
    Outputs outputs(json ? Outputs::Plan{.files = {*json}} : Outputs::Plan{.files = chart_files(folder, question)});

    const ScratchFolder scratch;
    std::vector<std::string> options = {"--question", question, "--out", ".", "--seed", arguments.text("--seed")};
    for (const auto* option : {"--quick", "--rows"})
        if (arguments.has(option)) options.push_back(option);
    run_for_us(chapter.path, options,
               {.output = json ? ProcessOptions::Stream::captured : ProcessOptions::Stream::passed_on,
                .folder = scratch.path()});  // so that messages name the files by what follows

    const auto made = scratch.path() / chapter.folder;
    if (json) {
        write_json(read_file(made / (question + ".json")), outputs[*json]);
    } else {
        outputs.say("\n");
        for (const auto& path : chart_files(folder, question)) {
            write_file(outputs[path], read_file(made / path.filename()));
            outputs.say(path.string() + "\n");
        }
    }
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
