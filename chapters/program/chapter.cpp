#include "chapter_programs.h"
#include "commands.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/process.h"

namespace raylab {

namespace {

std::string help() {
    std::string text = "raylab chapter NN [...]: runs one chapter\n\n";
    for (const auto& chapter : listed_chapters())
        text += "  " + chapter.folder.substr(0, 2) + "  " + chapter.title + ": " + chapter.question + "\n";
    return text + "\nWhat follows the number goes to the chapter's program: raylab chapter 02 --help\n";
}

}  // namespace

ExitCode chapter_command(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "--help" || words[0] == "-h") throw HelpWanted{help()};
    const auto chapter = built_chapter(words[0]);
    constexpr auto passed_on = ProcessOptions::Stream::passed_on;
    const auto result =
        run_process(chapter.path, {words.begin() + 1, words.end()}, {.output = passed_on, .errors = passed_on});
    if (result.end != ProcessResult::End::exited) throw Error(chapter.folder + ": " + to_string(result));
    return static_cast<ExitCode>(result.code);
}

}  // namespace raylab
