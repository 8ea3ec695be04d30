#include "chapter_programs.h"
#include "commands.h"

#include "raylab/base/command_line.h"

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
    const auto result =
        run_for_us(chapter.path, {words.begin() + 1, words.end()}, {.output = ProcessOptions::Stream::passed_on});
    return static_cast<ExitCode>(result.code);
}

}  // namespace raylab
