#include "chapter_programs.h"
#include "commands.h"

#include "raylab/base/command_line.h"
#include "raylab/base/print.h"

namespace raylab {

namespace {

const CommandLine slides_command_line{
    .program = "raylab slides",
    .about =
        "Prints the address at which a chapter's page opens as a lecture, one step a screen, for any browser. The page\n"
        "is written first where DIR has none: its pictures only, without charts and failure cases.",
    .positionals = {{"NN", "the chapter: 7, 07 or 07_recursion"}},
    .options = {{"--out", "DIR", "the lab book's folder", "out"},
                {"--quick", "", "a page that is written first has fewer samples, smaller pictures"}}};

}  // namespace

ExitCode slides_command(const std::vector<std::string>& words) {
    const auto arguments = parse(slides_command_line, words);
    const auto chapter = built_chapter(arguments.text("NN"));
    const std::filesystem::path out = arguments.text("--out");
    const auto page = out / chapter.folder / "index.html";
    if (!std::filesystem::exists(page)) {
        std::vector<std::string> options = {"--only", "story", "--out", out.string()};
        if (arguments.has("--quick")) options.push_back("--quick");
        run_for_us(chapter.path, options);
    }
    print_text("file://" + std::filesystem::canonical(page).string() + "#slide-1\n");
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
