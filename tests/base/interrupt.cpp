#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/interrupt.h"
#include "raylab/base/outputs.h"
#include "raylab/base/process.h"
#include "raylab/base/program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

using namespace raylab;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

std::ptrdiff_t entries_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

/// An empty folder. It is no ScratchFolder, because a forked process would remove that as its own.
fs::path empty_folder() {
    const auto folder = fs::path(RAYLAB_BUILD) / "tests/interrupt";
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

void wait_until(const std::function<bool()>& true_at_last) {
    for (int tries = 0; tries < 1000 && !true_at_last(); ++tries) std::this_thread::sleep_for(5ms);
    REQUIRE(true_at_last());
}

/// A separate process that runs the body as a program of the lab.
pid_t started(const std::function<void()>& body) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child > 0) return child;
    _exit(run_program([&] {
        body();
        return ExitCode::as_it_should_be;
    }));
}

int exit_code_of(pid_t child) {
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    return WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("an interrupted program removes its temporaries and says by which signal it ended") {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        const auto folder = empty_folder();
        const auto file = folder / "file";
        const pid_t child = started([&] {
            Outputs outputs({.files = {file}, .folders = {folder / "folder"}});
            write_file(outputs[file], "unfinished");
            write_file(outputs.staged(folder / "folder").path / "inside", "unfinished");
            std::this_thread::sleep_for(60s);
        });
        wait_until([&] { return entries_in(folder) == 2; });
        kill(child, number);
        CHECK(exit_code_of(child) == 128 + number);
        CHECK(entries_in(folder) == 0);
    }
}

TEST_CASE("an interrupted program ends what it started, and lets it clean up") {
    const auto folder = empty_folder();
    const auto began = folder / "began", ended = folder / "ended";
    const std::string script =
        "trap 'touch " + ended.string() + "; exit' TERM; touch " + began.string() + "; sleep 60 & wait";
    const pid_t child = started([&] { run_process("sh", {"-c", script}); });
    wait_until([&] { return fs::exists(began); });
    kill(child, SIGTERM);
    CHECK(exit_code_of(child) == 128 + SIGTERM);
    CHECK(fs::exists(ended));
}

TEST_CASE("an interrupt kills a program that will not end") {
    const auto folder = empty_folder();
    const auto began = folder / "began";
    const std::string script = "trap '' TERM; echo $$ > " + began.string() + "; while :; do sleep 1; done";
    const pid_t child = started([&] { run_process("sh", {"-c", script}); });
    wait_until([&] { return fs::exists(began) && fs::file_size(began) > 0; });
    const auto id = static_cast<pid_t>(std::stol(read_file(began)));
    kill(child, SIGINT);
    CHECK(exit_code_of(child) == 128 + SIGINT);
    wait_until([&] { return kill(id, 0) != 0; });
}

TEST_CASE("an interrupt waits for what must not be cut in two") {
    const auto folder = empty_folder();
    const auto began = folder / "began", ended = folder / "ended";
    const pid_t child = started([&] {
        {
            const Uninterrupted whole;
            write_file(began, "");
            std::this_thread::sleep_for(200ms);
            write_file(ended, "");
        }
        std::this_thread::sleep_for(60s);
    });
    wait_until([&] { return fs::exists(began); });
    kill(child, SIGTERM);
    CHECK(exit_code_of(child) == 128 + SIGTERM);
    CHECK(fs::exists(ended));
}

TEST_CASE("a signal that was ignored stays ignored") {
    const auto folder = empty_folder();
    const auto began = folder / "began";
    signal(SIGHUP, SIG_IGN);
    const pid_t child = started([&] {
        write_file(began, "");
        std::this_thread::sleep_for(300ms);
    });
    signal(SIGHUP, SIG_DFL);
    wait_until([&] { return fs::exists(began); });
    kill(child, SIGHUP);
    CHECK(exit_code_of(child) == 0);
}
