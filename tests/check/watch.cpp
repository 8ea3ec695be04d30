#include "catch.h"
#include "says.h"

#include "raylab/base/process.h"

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

// Tests of `raylab watch`.

namespace fs = std::filesystem;
using namespace raylab;

namespace {

ProcessResult watch(const std::vector<std::string>& words, const std::string& keys = "") {
    std::vector<std::string> all{"watch"};
    all.insert(all.end(), words.begin(), words.end());
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", all, {.input = keys, .folder = RAYLAB_SOURCE, .timeout = 60});
}

// What a terminal is sent that announces 24-bit colours.
std::string watched_in_colors(const std::string& exercise, const fs::path& answer) {
    const auto program = (fs::path(RAYLAB_BUILD) / "raylab").string();
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) {
        for (const auto* name : {"NO_COLOR", "TERM_PROGRAM", "KITTY_WINDOW_ID"}) unsetenv(name);
        setenv("TERM", "xterm-256color", 1);
        setenv("COLORTERM", "truecolor", 1);
        execl(program.c_str(), "raylab", "watch", exercise.c_str(), "--answer", answer.c_str(), "--once", nullptr);
        _exit(127);
    }
    std::string sent;
    char bytes[4096];
    // At its end a terminal is an error.
    for (ssize_t count; (count = read(terminal, bytes, sizeof bytes)) > 0;)
        sent.append(bytes, static_cast<std::size_t>(count));
    close(terminal);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? sent : "it failed: " + sent;
}

}  // namespace

TEST_CASE("a watch checks what is there, shows the progress, the file and why it is not done") {
    const auto result = watch({"02", "--once"});
    INFO(result.output << result.errors);
    CHECK(result.code == 1);
    CHECK(says(result, "0 of "));
    CHECK(says(result, "exercises/02_ray_sphere/nearest_sphere_hit.cpp:1"));
    CHECK(says(result, "not written yet"));
}

TEST_CASE("a watch gives hints on request, goes on to the next exercise, and ends where it is told to") {
    const auto result = watch({"02"}, "hnq");
    INFO(result.output << result.errors);
    CHECK(result.code == 0);
    CHECK(says(result, "Hint 1 of 3"));
}

TEST_CASE("a watch tells the hint for what the answer has wrong, before those that the exercise gives") {
    const auto answer = fs::path(RAYLAB_SOURCE) / "exercises/02_ray_sphere/mistakes/far_root.cpp";
    const auto result = watch({"02", "--answer", answer.string()}, "hhq");
    INFO(result.output << result.errors);
    CHECK(says(result, "Your t is where the ray leaves the sphere. A picture needs where it enters"));
    CHECK(says(result, "Hint 1 of 3"));
}

TEST_CASE("a watch shows a small picture where the terminal announces colours, and none in a pipe") {
    const auto answer = fs::path(RAYLAB_SOURCE) / "exercises/02_ray_sphere/right/from_the_middle.cpp";
    const auto sent = watched_in_colors("02", answer);
    INFO(sent.substr(0, 1000));
    CHECK(sent.find("PASSED") != std::string::npos);
    std::size_t characters = 0;
    for (auto at = sent.find("▀"); at != sent.npos; at = sent.find("▀", at + 1)) ++characters;
    CHECK(characters > 500);  // some 75 x 9
    const auto piped = watch({"02", "--answer", answer.string(), "--once"});
    CHECK(says(piped, "PASSED"));
    CHECK_FALSE(says(piped, "▀"));
}
