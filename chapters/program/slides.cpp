#include "chapter_programs.h"
#include "commands.h"

#include "raylab/base/command_line.h"
#include "raylab/base/file.h"
#include "raylab/base/outputs.h"
#include "raylab/report/page/deck.h"

#include <fmt/format.h>

namespace raylab {

namespace {

namespace fs = std::filesystem;

constexpr const char* deck_name = "slides.html";

const CommandLine slides_command_line{
    .program = "raylab slides",
    .about =
        "Writes a chapter's page as a deck: one HTML file with everything in it, which opens as a lecture, one step a\n"
        "screen, in any browser and without a network. It holds what the page shows; where the lab book has none, the\n"
        "chapter is run first.",
    .positionals = {{"NN", "the chapter: 7, 07 or 07_recursion"}},
    .options = {{"-o,--output", "FILE", "the deck (default: slides.html beside the chapter's page)"},
                {"--book", "DIR", "the lab book's folder", "out"},
                {"--quick", "", "a page that is written first has fewer samples, smaller pictures, no charts"}}};

void write_page(const ChapterProgram& chapter, const Arguments& arguments) {
    std::vector<std::string> options = {"--out", arguments.text("--book")};
    if (arguments.has("--quick")) options.insert(options.end(), {"--quick", "--only", "story"});
    run_for_us(chapter.path, options);
}

}  // namespace

ExitCode slides_command(const std::vector<std::string>& words) {
    const auto arguments = parse(slides_command_line, words);
    const auto chapter = built_chapter(arguments.text("NN"));
    const auto folder = fs::path(arguments.text("--book")) / chapter.folder, page = folder / "index.html";
    const auto output = arguments.text_if_given("--output");
    Outputs outputs({.files = arguments.given({"--output"}), .folders = {folder}, .inputs = {page}});
    if (!fs::exists(page)) write_page(chapter, arguments);
    const auto deck = deck_from_page(page);
    if (output)
        outputs.write(*output, deck);
    else
        write_file(outputs.staged(folder).path / deck_name, deck);
    const auto file = fs::absolute(output ? fs::path(*output) : folder / deck_name).lexically_normal();
    outputs.say(
        fmt::format("file://{}\none file, {:.1f} MB\n", file.string(), 1e-6 * static_cast<double>(deck.size())));
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
