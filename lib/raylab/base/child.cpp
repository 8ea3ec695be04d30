#include "raylab/base/child.h"

#include "raylab/base/error.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <thread>

namespace raylab {

namespace {

void leave(pid_t parent) {
    // The child is killed when the thread of the parent that waits for it ends for any reason.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);
    setpgid(0, 0);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    signal(SIGPIPE, SIG_DFL);
}

[[noreturn]] void become(const Launch& launch) {
    leave(launch.parent);
    signal(SIGTTOU, SIG_IGN);  // so that a background group may write to the terminal
    const bool ready =
        dup2(launch.input, STDIN_FILENO) >= 0 && (launch.output < 0 || dup2(launch.output, STDOUT_FILENO) >= 0) &&
        (launch.errors < 0 || dup2(launch.errors, STDERR_FILENO) >= 0) && (!launch.folder || chdir(launch.folder) == 0);
    if (ready) execvp(launch.words[0], launch.words.data());
    const int problem = errno;
    if (write(launch.failure, &problem, sizeof problem) < 0) _exit(126);
    _exit(127);
}

void write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const auto count = write(file, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) _exit(126);
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

// Ends by _exit(), because functions that the parent registered for its exit must not run in the copy.
[[noreturn]] void work_as_copy(const CopyLaunch& launch) {
    leave(launch.parent);
    if (dup2(launch.output, STDOUT_FILENO) < 0 || dup2(launch.errors, STDERR_FILENO) < 0) _exit(127);
    try {
        write_all(STDOUT_FILENO, launch.work());
        _exit(0);
    } catch (const std::bad_alloc&) {
        write_all(STDERR_FILENO, "not enough memory");
    } catch (const std::exception& error) {
        write_all(STDERR_FILENO, error.what());
    }
    _exit(1);
}

/// Ends the group. The lab's own programs clean up on the first signal; whatever is left is killed. The program's id
/// cannot be reused meanwhile, because it has not been waited for.
void end_group(pid_t id) {
    using namespace std::chrono_literals;
    kill(-id, SIGTERM);
    const auto deadline = std::chrono::steady_clock::now() + 2s;
    siginfo_t info{};
    while (waitid(P_PID, static_cast<id_t>(id), &info, WEXITED | WNOWAIT | WNOHANG) == 0 && info.si_pid == 0 &&
           std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(2ms);
    kill(-id, SIGKILL);
}

double seconds_in(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Child::Child(const Launch& launch) : Child(Uninterrupted(), launch) {}

Child::Child(const Uninterrupted&, const Launch& launch) : id_(fork()) {
    if (id_ == 0) become(launch);
    watch();
}

// Interrupts are not blocked here, because the copy would inherit a lock that belongs to a thread of the parent. If an
// interrupt comes first, the copy is killed when the parent dies.
Child::Child(const CopyLaunch& launch) : id_(fork()) {
    if (id_ == 0) work_as_copy(launch);
    watch();
}

void Child::watch() {
    if (id_ < 0) throw Error(std::string("expected to start a program, found: ") + std::strerror(errno));
    setpgid(id_, id_);  // both processes do this, so that the group exists before either goes on
    ending_.emplace([id = id_] { end_group(id); });
}

Child::~Child() {
    if (!status_) kill_group();
    end();
}

void Child::kill_group() const { kill(-id_, SIGKILL); }

int Child::end() {
    if (status_) return *status_;
    // The group is killed before waitpid(): after it the id might belong to another process.
    siginfo_t info;
    while (waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
    }
    kill_group();
    ending_.reset();
    int status = 0;
    rusage used{};
    while (wait4(id_, &status, 0, &used) < 0 && errno == EINTR) {
    }
    status_ = status;
    cpu_seconds_ = seconds_in(used.ru_utime) + seconds_in(used.ru_stime);
    return status;
}

}  // namespace raylab
