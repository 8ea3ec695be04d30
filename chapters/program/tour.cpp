#include "chapter_programs.h"
#include "commands.h"
#include "course/mistakes_page.h"

#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/outputs.h"
#include "raylab/base/print.h"
#include "raylab/base/process.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/json_text.h"
#include "raylab/report/page/book.h"
#include "raylab/report/table.h"
#include "raylab/scene/read_scene.h"
#include "raylab/transport/path/transport_picture.h"

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

const CommandLine tour_command_line{
    .program = "raylab tour",
    .about = "Runs every chapter and writes the lab book: DIR/index.html, to be read in any browser.",
    .options = {{"--out", "DIR", "the lab book's folder", "out"},
                {"--quick", "", "fewer samples, smaller pictures: two to four minutes"},
                threads_option(),
                {"--seed", "S", "the seed of all random numbers", "1"},
                {"--json", "FILE", "the result of each chapter as JSON; - is standard output"}}};

std::vector<std::string> options_for(const std::vector<ChapterProgram>& chapters, std::size_t at,
                                     const Arguments& arguments) {
    std::vector<std::string> options = {"--in-book",
                                        "--out",
                                        arguments.text("--out"),
                                        "--threads",
                                        arguments.text("--threads"),
                                        "--seed",
                                        arguments.text("--seed")};
    if (arguments.has("--quick")) options.push_back("--quick");
    if (at > 0) options.insert(options.end(), {"--previous", chapters[at - 1].folder});
    if (at + 1 < chapters.size()) options.insert(options.end(), {"--next", chapters[at + 1].folder});
    return options;
}

// Runs a chapter. Its progress bars go to the terminal; where it fails it has already printed the reason on stderr.
BookEntry run_one(const std::vector<ChapterProgram>& chapters, std::size_t at, const Arguments& arguments) {
    const auto& chapter = chapters[at];
    const auto folder = fs::path(arguments.text("--out")) / chapter.folder;
    const auto result =
        run_process(chapter.path, options_for(chapters, at, arguments), {.errors = ProcessOptions::Stream::passed_on});
    if (result.end == ProcessResult::End::exited && result.code <= 1) {
        auto entry = read_entry(folder);
        entry.seconds = result.seconds;
        return entry;
    }
    const BookEntry entry{.folder = chapter.folder,
                          .title = chapter.title,
                          .question = chapter.question,
                          .seconds = result.seconds,
                          .problem = to_string(result)};
    write_problem_page(folder, entry);
    return entry;
}

// Chapter 07's still life by distributed rays: soft shadows, and a lens that is sharp at the glass ball.
Image cover(const Arguments& arguments) {
    const Scene scene = read_scene(source_folder() / "chapters/15_distributed/scenes/still_life.toml");
    const bool quick = arguments.has("--quick");
    const ImageSize size = quick ? ImageSize{640, 280} : scene.image;
    const Sampler sampler{.kind = SamplerKind::sobol, .count = quick ? 16 : 64};
    const CameraFrame frame = camera_frame(scene.camera, size, scene.source);
    const auto accelerator = make_accelerator("auto", scene);
    const TransportPicture picture(scene, *accelerator, frame, {.shares = FacetShares::fresnel});
    SampledImage image(size.width, size.height);
    picture.add_adaptively(image, sampler, threads_of(arguments), "cover");
    return image.mean();
}

std::string verdict_of(const BookEntry& entry) {
    if (!entry.problem.empty()) return "✗ did not run: " + entry.problem;
    if (entry.cases == 0) return "✓";
    const auto counts = std::to_string(entry.cases_as_expected) + " of " + std::to_string(entry.cases);
    return (entry.cases == entry.cases_as_expected ? "✓ " : "✗ ") + counts + " cases as expected";
}

ExitCode worst_of(const std::vector<BookEntry>& entries) {
    if (!std::ranges::all_of(entries, [](const BookEntry& entry) { return entry.problem.empty(); }))
        return ExitCode::could_not;
    const auto good = [](const BookEntry& entry) { return entry.cases == entry.cases_as_expected; };
    return std::ranges::all_of(entries, good) ? ExitCode::as_it_should_be : ExitCode::negative;
}

nlohmann::ordered_json to_json(const std::vector<BookEntry>& entries, const std::vector<Fact>& facts) {
    nlohmann::ordered_json json = {{"machine", nlohmann::ordered_json::object()},
                                   {"chapters", nlohmann::ordered_json::array()}};
    for (const auto& [name, value] : facts) json["machine"][name] = value;
    for (const auto& entry : entries)
        json["chapters"].push_back({{"folder", entry.folder},
                                    {"title", entry.title},
                                    {"question", entry.question},
                                    {"seconds", entry.seconds},
                                    {"cases", entry.cases},
                                    {"cases_as_expected", entry.cases_as_expected},
                                    {"problem", entry.problem}});
    return json;
}

}  // namespace

ExitCode tour_command(const std::vector<std::string>& words) {
    const auto arguments = parse(tour_command_line, words);
    const auto json = arguments.text_if_given("--json");
    const auto say = [&](const std::string& text) {
        if (json == "-") return;
        print_text(text);
        flush_standard_output();
    };
    // Refused here once, not by each chapter.
    const auto seed = *seed_if_given(arguments);
    const auto threads = threads_of(arguments);
    const fs::path folder = arguments.text("--out");
    auto written = arguments.given({"--json"});
    for (const auto* name : book_file_names) written.push_back(folder / name);
    for (const auto* name : {book_cover, book_mistakes}) written.push_back(folder / name);
    Outputs outputs({.files = written});
    const auto chapters = listed_chapters();
    if (chapters.empty()) throw Error("expected chapters in the build folder, found none");
    std::vector<BookEntry> entries;
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        const auto name = fmt::format("{:>2} of {}  {} {}", i + 1, chapters.size(), chapters[i].folder.substr(0, 2),
                                      chapters[i].title);
        const auto dots =
            std::string(std::max<std::size_t>(3, 50 - std::min<std::size_t>(50, length_shown(name))), '.');
        if (json != "-" && isatty(STDOUT_FILENO)) {  // a progress bar may overwrite the line
            print_data(name + "\r");
            flush_standard_output();
        }
        entries.push_back(run_one(chapters, i, arguments));
        const auto seconds = duration_text(1e9 * entries.back().seconds);
        say(name + " " + dots + " " + seconds + "  " + verdict_of(entries.back()) + "\n");
    }
    auto facts = machine_facts();
    facts.push_back({"run", arguments.has("--quick") ? "quick: fewer samples, smaller pictures" : "full"});
    facts.push_back({"seed", arguments.text("--seed")});
    for (const auto& [name, text] : book_files(folder, entries, facts)) write_file(outputs[folder / name], text);
    write_image(cover(arguments), outputs[folder / book_cover]);
    say("The exercises: every typical mistake is judged\n");
    write_file(outputs[folder / book_mistakes], mistakes_page(seed, threads));
    if (json) write_json(json_text(to_json(entries, facts)), outputs[*json]);
    if (json != "-") outputs.say("\nThe lab book: " + (folder / "index.html").string() + "\n");
    outputs.commit();
    return worst_of(entries);
}

}  // namespace raylab
