#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

// Runs another program in a process group of its own; it does not read this program's standard input, and does not
// outlive it.

namespace raylab {

/// How a program is run.
struct ProcessOptions {
    enum class Stream { captured, passed_on };  // passed_on: directly to this program's own stream
    Stream output = Stream::captured;
    Stream errors = Stream::captured;
    std::string input = {};             // the content of its standard input
    std::filesystem::path folder = {};  // its working folder; empty: the current one
    double timeout = 0;                 // in seconds, after which the whole group is killed; 0: no limit
    // Bytes of each captured stream; the program is killed when it writes more.
    std::size_t output_limit = std::size_t{1} << 26;
    // Asked twenty times a second while the program runs; the reason that it gives to kill the program, or nothing.
    std::function<std::string()> objection = {};
};

/// How a program ended, and its output.
struct ProcessResult {
    enum class End { exited, signalled, timed_out, flooded, objected } end = End::exited;
    int code = 0;                // the exit code or, where it was killed by a signal, the signal's number
    std::string output, errors;  // the captured stdout and stderr
    double seconds = 0;
    double cpu_seconds = 0;      // of the processor, with the processes that the program waited for
    double timeout = 0;          // the timeout of the ProcessOptions
    std::string objection = {};  // why it was killed, where the ProcessOptions had a reason

    bool succeeded() const { return end == End::exited && code == 0; }
};

/// "exit code 2", "killed by signal 11 (Segmentation fault)", "did not end within 5 seconds", "stopped: too much
/// output".
std::string to_string(const ProcessResult& result);

/// The reason for a program's failure, on one line: "gnuplot did not end within 60 seconds", "gnuplot: exit code 1:
/// line 7: undefined variable: x" (what it printed on stderr, or else on stdout).
std::string failure_of(const std::string& program, const ProcessResult& result);

/// Runs a program, given by its path or found in the PATH, and waits for its end; processes that it left running are
/// killed. It throws an Error where the program cannot be started.
ProcessResult run_process(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const ProcessOptions& options = {});

/// Runs `work` in a copy of this process, so that a foreign library which aborts, exits or writes on stderr affects
/// only the copy. `output` is the result of `work`; where it throws, `errors` is what() and the exit code is 1. Of the
/// options only the timeout and the limit are used.
ProcessResult run_in_copy(const std::function<std::string()>& work, const ProcessOptions& options = {});

/// The path of a program in the PATH; empty where it is not found.
std::filesystem::path find_program(const std::string& name);

}  // namespace raylab
