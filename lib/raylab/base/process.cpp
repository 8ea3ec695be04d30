#include "raylab/base/process.h"

#include "raylab/base/child.h"
#include "raylab/base/descriptor.h"
#include "raylab/base/error.h"
#include "raylab/base/print.h"
#include "raylab/base/printable.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace raylab {

namespace {

using Clock = std::chrono::steady_clock;
using Stream = ProcessOptions::Stream;

/// A captured stream: what has been read so far, and whether it is still open.
struct Capture {
    int number;
    std::string* text;
    bool open = true;
};

void read_some(Capture& stream) {
    std::array<char, 65536> bytes;
    const auto count = read(stream.number, bytes.data(), bytes.size());
    if (count > 0) stream.text->append(bytes.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) stream.open = false;
}

void drain(Capture& stream) {
    fcntl(stream.number, F_SETFL, O_NONBLOCK);
    for (auto before = std::string::npos; stream.open && before != stream.text->size();) {
        before = stream.text->size();
        read_some(stream);
    }
}

constexpr auto never = Clock::time_point::max();
// In between a program may write some megabytes more than it is allowed.
constexpr auto between_questions = std::chrono::milliseconds(50);

/// When a program has to be looked at, even if it says nothing.
struct Deadlines {
    Clock::time_point end = never, question = never;

    explicit Deadlines(const ProcessOptions& options) {
        const auto now = Clock::now();
        if (options.timeout > 0)
            end = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.timeout));
        if (options.objection) question = now + between_questions;
    }

    int milliseconds() const {
        const auto next = std::min(end, question);
        if (next == never) return -1;
        const auto left = std::chrono::duration<double, std::milli>(next - Clock::now()).count();
        return static_cast<int>(std::ceil(std::max(0.0, std::min(left, 1e9))));
    }
};

/// How a program ended, and why where there was an objection.
struct Ending {
    ProcessResult::End end;
    std::string objection = {};
};

/// Reads until the program has ended, exceeds its time, prints too much, or there is an objection. The end of the
/// program itself counts, because a process that it started may keep the pipes open for longer.
Ending follow(const Child& child, std::vector<Capture>& streams, const ProcessOptions& options) {
    using End = ProcessResult::End;
    // The syscall is used directly, because glibc has a wrapper only since 2.36.
    const Descriptor ended(static_cast<int>(syscall(SYS_pidfd_open, child.id(), 0)));
    Deadlines deadlines(options);
    while (true) {
        std::vector<pollfd> watched = {{ended.number(), POLLIN, 0}};
        for (const auto& stream : streams) watched.push_back({stream.open ? stream.number : -1, POLLIN, 0});
        if (poll(watched.data(), watched.size(), deadlines.milliseconds()) < 0) {
            if (errno == EINTR) continue;
            throw Error(std::string("cannot wait for a program: ") + std::strerror(errno));
        }
        for (std::size_t i = 0; i < streams.size(); ++i) {
            if (watched[i + 1].revents) read_some(streams[i]);
            if (streams[i].text->size() > options.output_limit) return {End::flooded};
        }
        if (watched[0].revents) return {End::exited};
        const auto now = Clock::now();
        if (now >= deadlines.end) return {End::timed_out};
        if (now < deadlines.question) continue;
        if (auto objection = options.objection(); !objection.empty()) return {End::objected, std::move(objection)};
        deadlines.question = Clock::now() + between_questions;
    }
}

ProcessResult result_of(Child& child, const Descriptor& output, const Descriptor& errors,
                        const ProcessOptions& options) {
    const auto start = Clock::now();
    ProcessResult result{.timeout = options.timeout};
    std::vector<Capture> streams = {{output.number(), &result.output}, {errors.number(), &result.errors}};
    auto [end, objection] = follow(child, streams, options);
    result.end = end;
    result.objection = std::move(objection);
    if (result.end != ProcessResult::End::exited) child.kill_group();
    const int status = child.end();
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    result.cpu_seconds = child.cpu_seconds();
    if (result.end != ProcessResult::End::exited) return result;
    for (auto& stream : streams) drain(stream);
    if (WIFSIGNALED(status)) result.end = ProcessResult::End::signalled;
    result.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return result;
}

void throw_if_not_started(const Descriptor& failure, const std::filesystem::path& program) {
    int problem = 0;
    ssize_t count = 0;
    while ((count = read(failure.number(), &problem, sizeof problem)) < 0 && errno == EINTR) {
    }
    if (count > 0) throw Error({program.string()}, "a program that can be run", std::strerror(problem));
}

}  // namespace

ProcessResult run_process(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const ProcessOptions& options) {
    const Descriptor input = memory_file(options.input);
    Pipe output = make_pipe(), errors = make_pipe(), failure = make_pipe();
    // The path is then made absolute here, before the child changes its folder.
    const bool has_folder = program.has_parent_path();
    std::vector<std::string> words = {(has_folder ? std::filesystem::absolute(program) : program).string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    Launch launch{.words = {},
                  .folder = options.folder.empty() ? nullptr : options.folder.c_str(),
                  .input = input.number(),
                  .output = options.output == Stream::captured ? output.write.number() : -1,
                  .errors = options.errors == Stream::captured ? errors.write.number() : -1,
                  .failure = failure.write.number(),
                  .parent = getpid()};
    for (auto& word : words) launch.words.push_back(word.data());
    launch.words.push_back(nullptr);

    flush_standard_output();  // otherwise buffered output would come after the program's output
    Child child(launch);
    output.write.close();
    errors.write.close();
    failure.write.close();
    throw_if_not_started(failure.read, program);

    return result_of(child, output.read, errors.read, options);
}

ProcessResult run_in_copy(const std::function<std::string()>& work, const ProcessOptions& options) {
    Pipe output = make_pipe(), errors = make_pipe();
    flush_standard_output();  // otherwise the copy would print it, too
    Child child(CopyLaunch{work, output.write.number(), errors.write.number(), getpid()});
    output.write.close();
    errors.write.close();
    return result_of(child, output.read, errors.read, options);
}

std::string to_string(const ProcessResult& result) {
    switch (result.end) {
        case ProcessResult::End::exited:
            return "exit code " + std::to_string(result.code);
        case ProcessResult::End::signalled:
            return "killed by signal " + std::to_string(result.code) + " (" + strsignal(result.code) + ")";
        case ProcessResult::End::timed_out:
            return fmt::format("did not end within {} seconds", result.timeout);
        case ProcessResult::End::flooded:
            return "stopped: too much output";
        case ProcessResult::End::objected:
            return "stopped: " + result.objection;
    }
    return "";
}

std::string failure_of(const std::string& program, const ProcessResult& result) {
    if (result.end == ProcessResult::End::timed_out) return program + " " + to_string(result);
    const std::string said = on_one_line(result.errors.empty() ? result.output : result.errors);
    return program + ": " + to_string(result) + (said.empty() ? "" : ": " + said);
}

std::filesystem::path find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const auto program = std::filesystem::path(folder) / name;
        std::error_code closed;  // a folder that this user may not look into has no program for it
        if (!folder.empty() && std::filesystem::is_regular_file(program, closed) && access(program.c_str(), X_OK) == 0)
            return program;
    }
    return {};
}

}  // namespace raylab
