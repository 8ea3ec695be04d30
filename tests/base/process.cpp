#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/base/process.h"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

using namespace raylab;
using End = ProcessResult::End;

namespace {

ProcessResult shell(const std::string& script, const ProcessOptions& options = {}) {
    return run_process("sh", {"-c", script}, options);
}

// A killed process that nobody has waited for is still listed, but has no command line any more.
bool still_runs(int id) {
    for (int tries = 0; tries < 100; ++tries) {
        std::ifstream file("/proc/" + std::to_string(id) + "/cmdline");
        if (file.peek() == std::ifstream::traits_type::eof()) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

}  // namespace

TEST_CASE("a program's exit code, stdout and stderr come back") {
    const auto result = shell("echo out; echo err >&2; exit 3");
    CHECK(result.end == End::exited);
    CHECK(result.code == 3);
    CHECK(result.output == "out\n");
    CHECK(result.errors == "err\n");
    CHECK(!result.succeeded());
    CHECK(to_string(result) == "exit code 3");
}

TEST_CASE("arguments arrive as they are, whatever they hold") {
    const auto result = run_process("printf", {"[%s]", "a b", "$HOME", "'\"\\", ""});
    CHECK(result.output == "[a b][$HOME]['\"\\][]");
}

TEST_CASE("a program killed by a signal says which") {
    const auto result = shell("kill -SEGV $$");
    CHECK(result.end == End::signalled);
    CHECK(result.code == SIGSEGV);
}

TEST_CASE("a program that takes too long is killed with all it started, and what it wrote is kept") {
    const auto result = shell("sleep 77 & echo $!; sleep 77; echo never", {.timeout = 0.3});
    CHECK(result.end == End::timed_out);
    CHECK(result.seconds < 5);
    CHECK(!still_runs(std::stoi(result.output)));
    CHECK(to_string(result) == "did not end within 0.3 seconds");
}

TEST_CASE("why a program failed is one line: how it ended, and what it said on stderr, or else on stdout") {
    CHECK(failure_of("cc", shell("echo '  first'; echo 'second'; exit 1")) == "cc: exit code 1: first second");
    CHECK(failure_of("cc", shell("echo out; echo err >&2; exit 1")) == "cc: exit code 1: err");
    CHECK(failure_of("cc", shell("exit 1")) == "cc: exit code 1");
    CHECK(failure_of("cc", shell("echo late; sleep 77", {.timeout = 0.3})) == "cc did not end within 0.3 seconds");
}

TEST_CASE("what a program leaves running does not keep us waiting") {
    const auto result = shell("sleep 77 & echo $!");
    CHECK(result.succeeded());
    CHECK(result.seconds < 5);
    CHECK(!still_runs(std::stoi(result.output)));
}

TEST_CASE("endless output is cut off") {
    const auto result = shell("yes", {.timeout = 20, .output_limit = 100'000});
    CHECK(result.end == End::flooded);
    CHECK(result.output.size() < 300'000);
}

TEST_CASE("a program is killed where there is an objection to it, and the reason is told") {
    int asked = 0;
    const auto grown = [&] { return ++asked < 3 ? std::string() : std::string("its folder has 300 MB"); };
    const auto result = shell("sleep 77", {.timeout = 20, .objection = grown});
    CHECK(result.end == End::objected);
    CHECK(to_string(result) == "stopped: its folder has 300 MB");
    CHECK(result.seconds < 5);
}

TEST_CASE("the processor's time is that of the program and of what it waited for, not that of waiting") {
    const auto busy = shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done");
    CHECK(busy.cpu_seconds > 0.01);
    CHECK(shell("sleep 0.3").cpu_seconds < 0.2);
}

TEST_CASE("large input and large output pass, and input that nobody reads does not block") {
    const std::string large(3'000'000, 'x');
    CHECK(run_process("cat", {}, {.input = large}).output == large);
    CHECK(run_process("true", {}, {.input = large}).succeeded());
}

TEST_CASE("a program without input reads its end at once") {
    CHECK(run_process("cat", {}, {.timeout = 5}).succeeded());
}

TEST_CASE("a program that is not there is an Error, as is a folder that is not there") {
    CHECK_THROWS_AS(run_process("no-such-program-here", {}), Error);
    CHECK_THROWS_AS(run_process("true", {}, {.folder = "/no/such/folder"}), Error);
}

TEST_CASE("a program runs in the folder it is told to") {
    CHECK(run_process("pwd", {}, {.folder = "/"}).output == "/\n");
}

TEST_CASE("what a copy of this process returns comes back, whatever it holds") {
    std::string bytes(3'000'000, '\xff');
    bytes[1] = '\0';
    const auto result = run_in_copy([&] { return bytes; });
    CHECK(result.succeeded());
    CHECK(result.output == bytes);
    CHECK(result.errors.empty());
}

TEST_CASE(
    "what becomes of a copy of this process does not become of this one: an exception, a signal, an exit, no end") {
    const auto thrown = run_in_copy([]() -> std::string { throw Error("expected more"); });
    CHECK(failure_of("the copy", thrown) == "the copy: exit code 1: expected more");
    const auto died = run_in_copy([]() -> std::string {
        std::fputs("why\n", stderr);
        std::signal(SIGSEGV, SIG_DFL);
        std::raise(SIGSEGV);
        return "";
    });
    CHECK(died.end == End::signalled);
    CHECK(died.code == SIGSEGV);
    CHECK(died.errors == "why\n");
    CHECK(run_in_copy([]() -> std::string { _exit(5); }).code == 5);
    const auto endless = run_in_copy([] { return std::to_string(pause()); }, {.timeout = 0.2});
    CHECK(failure_of("the copy", endless) == "the copy did not end within 0.2 seconds");
}

TEST_CASE("programs run from several threads at once keep their outputs apart", "[threads]") {
    std::vector<std::string> outputs(8);
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < outputs.size(); ++i)
            threads.emplace_back([&, i] { outputs[i] = shell("echo " + std::to_string(i)).output; });
    }
    for (std::size_t i = 0; i < outputs.size(); ++i) CHECK(outputs[i] == std::to_string(i) + "\n");
}

TEST_CASE("the PATH is searched for a program") {
    CHECK(find_program("sh").filename() == "sh");
    CHECK(find_program("no-such-program-here").empty());
}
