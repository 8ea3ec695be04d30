#include "../commands.h"
#include "watched_exercise.h"

#include "exercise.h"
#include "hints.h"

#include "raylab/base/command_line.h"
#include "raylab/base/print.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <string>

namespace raylab {

namespace {

using namespace grading;

const CommandLine watch_command_line{
    .program = "raylab watch",
    .about =
        "Checks your answer to one exercise each time you save it, and goes on to the next once it passes.\n"
        "While it runs: h a hint, and once more the next one; a all that the check says; n the next exercise;\n"
        "q quit. It looks at the file's time, so that it works over SSH and in containers. A terminal that says that it\n"
        "shows pictures (kitty, iTerm2), or 24-bit colours (COLORTERM=truecolor), shows a small one.",
    .positionals = {{"NN", "the exercise to begin with (default: the first that is not done)",
                     Positional::Count::optional}},
    .options = {{"--answer", "FILE", "your file for NN (default: exercises/NN_name/...cpp)"},
                {"--once", "", "check once and stop; exit code 0: passed"}}};

constexpr int looks_each = 300;  // milliseconds

// What was typed since the last look; absent where the input has ended.
std::optional<std::string> typed_keys() {
    pollfd standard_input{STDIN_FILENO, POLLIN, 0};
    if (poll(&standard_input, 1, looks_each) <= 0) return "";
    char bytes[256];
    const auto count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) return std::nullopt;
    return std::string(bytes, static_cast<std::size_t>(count));
}

std::string progress_of(const std::vector<WatchedExercise>& all) {
    std::string dots;
    for (const auto& one : all) dots += one.passed() ? "●" : one.is_begun() ? "◐" : "○";
    return fmt::format("{}  {} of {} done", dots, std::ranges::count_if(all, &WatchedExercise::passed), all.size());
}

std::size_t first_open(const std::vector<WatchedExercise>& all, std::size_t from) {
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const auto at = (from + i) % all.size(); !all[at].passed()) return at;
    return from;
}

void say_progress(const std::vector<WatchedExercise>& all, const WatchedExercise& current) {
    print_text(fmt::format("\n{}\nExercise {}: {}\n\n{}\n", progress_of(all), current.name(), current.file(),
                           current.in_short()));
    print_data(current.preview());
    flush_standard_output();
}

}  // namespace

ExitCode watch_command(const std::vector<std::string>& words) {
    const auto arguments = parse(watch_command_line, words);
    std::vector<WatchedExercise> all;
    for (const auto& exercise : exercises()) all.emplace_back(exercise);
    std::size_t current = first_open(all, 0);
    if (const auto name = arguments.text_if_given("NN"))
        current = static_cast<std::size_t>(&exercise(*name) - exercises().data());
    if (const auto file = arguments.text_if_given("--answer")) all[current] = {exercises()[current], *file};

    std::size_t hints_given = 0;
    if (all[current].look()) say_progress(all, all[current]);
    if (arguments.has("--once")) return all[current].passed() ? ExitCode::as_it_should_be : ExitCode::negative;
    while (const auto keys = typed_keys()) {
        for (const char key : *keys) {
            if (key == 'q') return ExitCode::as_it_should_be;
            if (key == 'a') print_text(all[current].at_length());
            if (key == 'h') print_text(all[current].hint(hints_given++));
            if (key == 'n') current = first_open(all, current + 1), hints_given = 0, all[current].forget();
        }
        if (all[current].look()) {
            say_progress(all, all[current]);
            if (all[current].passed()) {
                current = first_open(all, current), hints_given = 0;
                if (!all[current].passed())
                    print_text(fmt::format("Next: exercise {}, {}\n", all[current].name(), all[current].readme()));
            }
        }
        flush_standard_output();
    }
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
