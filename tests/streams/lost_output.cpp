#include "catch.h"
#include "rotating.h"
#include "streams/program.h"

#include "raylab/base/file.h"

#include <algorithm>
#include <set>
#include <sstream>

using namespace raylab;

namespace {

using Words = std::vector<std::string>;

/// Every third of the short runs: what they print and say is tested of a command in one run of three.
std::vector<ShortRun> short_runs_now() {
    std::vector<ShortRun> now;
    const auto all = short_runs();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (is_tested_now(i, 3)) now.push_back(all[i]);
    return now;
}

/// The words themselves, and the same words with options that print something else.
std::vector<Words> variants(const ShortRun& run) {
    std::vector<Words> all = {run.words};
    const auto with = [&](const Words& more) {
        all.push_back(run.words);
        all.back().insert(all.back().end(), more.begin(), more.end());
    };
    if (run.words[0] != "help" && run.words[0] != "chapter") with({"--help"});
    if (run.json == ShortRun::Json::has_option) with({"--json", "-"});
    return all;
}

std::string text_of(const Words& words) {
    std::string text;
    for (const auto& word : words) text += word + " ";
    return text;
}

/// The commands that `raylab help` lists.
std::set<std::string> commands() {
    std::set<std::string> names;
    std::istringstream lines(in_shell({"help"}).output);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream parts(line);
        std::string program, name;
        if (line.starts_with("  raylab ") && parts >> program >> name) names.insert(name);
    }
    return names;
}

}  // namespace

TEST_CASE("every command of the program has a short run") {
    std::set<std::string> run = {};
    for (const auto& [words, json] : short_runs()) run.insert(words[0]);
    run.erase("help");
    run.insert({"handout", "package"});  // they take seconds: tests/grade runs them
    CHECK(run.size() >= 13);
    CHECK(run == commands());
}

TEST_CASE("every command prints something in its short run") {
    for (const auto& [words, json] : short_runs_now()) {
        if (words[0] == "tour") continue;  // it would take a minute
        INFO(text_of(words));
        const auto heard = in_shell(words);
        CHECK(heard.code == 0);
        CHECK(heard.errors == "");
        CHECK_FALSE(heard.output.empty());
    }
}

TEST_CASE("every command says when its output is lost: exit code 2, one line") {
    for (const auto& run : short_runs_now())
        for (const auto& words : variants(run)) {
            INFO(text_of(words));
            check_could_not(in_shell(words, {.suffix = ">/dev/full"}),
                            "standard output: expected a place that can be written, found No space left on device");
        }
}

TEST_CASE("every command says when its output is closed: exit code 2, one line") {
    for (const auto& [words, json] : short_runs_now()) {
        if (words[0] == "tour") continue;  // it prints only after the first chapter
        INFO(text_of(words));
        check_could_not(in_shell(words, {.suffix = ">&-"}),
                        "standard output: expected a place that can be written, found Bad file descriptor");
    }
}

TEST_CASE("a chapter's own program says when its output is lost") {
    const std::string chapter = RAYLAB_BUILD "/chapters/04_transforms/04_transforms";
    for (const auto* option : {"--help", "--list"}) {
        INFO(option);
        check_could_not(run_process("sh", {"-c", chapter + " " + option + " >/dev/full"}), "standard output");
    }
}

TEST_CASE("a reader that has gone is no complaint, whether SIGPIPE ends the program or not") {
    for (const Words& words : {Words{"help"},
                               {"chart"},
                               {"chapter", "04", "--list"},
                               {"needs", still_life},
                               {"needs", still_life, "--json", "-"}})
        for (const std::string trap : {"", "trap '' PIPE; "}) {
            INFO(text_of(words) << trap);
            const auto result = in_shell(words, {.prefix = trap + "{ sleep 0.2; ", .suffix = "; } | exit 0; exit 0"});
            CHECK(result.errors == "");
        }
}

TEST_CASE("no file that is written becomes a standard stream where those are closed") {
    const auto picture = (streams_folder / "closed.png").string(), open = (streams_folder / "open.png").string();
    REQUIRE(in_shell({"render", still_life, "--size", "8x8", "-o", open}).code == 0);
    std::filesystem::remove(picture);
    const auto result = in_shell({"render", still_life, "--size", "8x8", "-o", picture}, {.suffix = "<&- >&- 2>&-"});
    CHECK(result.code == 2);
    if (std::filesystem::exists(picture)) CHECK(read_file(picture) == read_file(open));
}

TEST_CASE("a chart is drawn where standard input is closed") {
    const auto result = in_shell({"chart", "phong_specular", "--quick", "-o", streams_folder}, {.suffix = "<&-"});
    CHECK(result.errors == "");
    CHECK(result.code == 0);
}
