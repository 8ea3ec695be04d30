#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

// Running another program: its own process group, no standard input of ours, gone when we are gone.

namespace raylab {

/// How a program is to be run.
struct ProcessOptions {
    enum class Stream { captured, passed_on };  // passed_on: straight to our own
    Stream output = Stream::captured;
    Stream errors = Stream::captured;
    std::string input = {};                           // what it reads on standard input
    std::filesystem::path folder = {};                // where it runs; empty: where we are
    double timeout = 0;                               // seconds, then the whole group is killed; 0: as long as it takes
    std::size_t output_limit = std::size_t{1} << 26;  // bytes of each captured stream; one byte more and it is killed
};

/// What became of a program.
struct ProcessResult {
    enum class End { exited, signalled, timed_out, flooded } end = End::exited;
    int code = 0;                // exit code; where signalled, the signal's number
    std::string output, errors;  // what was captured of stdout and stderr
    double seconds = 0;
    double timeout = 0;  // what ProcessOptions allowed it

    bool succeeded() const { return end == End::exited && code == 0; }
};

/// "exit code 2", "killed by signal 11 (Segmentation fault)", "did not end within 5 seconds", "stopped: too much
/// output".
std::string to_string(const ProcessResult& result);

/// Why a program did not succeed, on one line: "gnuplot did not end within 60 seconds", "gnuplot: exit code 1: line 7:
/// undefined variable: x" (what it printed on stderr, or else on stdout).
std::string failure_of(const std::string& program, const ProcessResult& result);

/// Runs a program, by its path or as the PATH finds it, and waits for its end; what it started and left running is
/// killed. Error where it cannot be started.
ProcessResult run_process(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const ProcessOptions& options = {});

/// Runs `work` in a copy of this process: what a foreign library does to it, abort, exit or write on stderr, it does to
/// the copy alone. `output` is what `work` returned; where it threw, `errors` is what() and the exit code 1. Of the
/// options the timeout and the limit count.
ProcessResult run_in_copy(const std::function<std::string()>& work, const ProcessOptions& options = {});

/// A program the PATH finds; empty: it does not.
std::filesystem::path find_program(const std::string& name);

}  // namespace raylab
