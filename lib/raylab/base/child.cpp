#include "raylab/base/child.h"

#include "raylab/base/error.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

namespace raylab {

namespace {

[[noreturn]] void become(const Launch& launch) {
    // When the thread that waits for us dies, however it dies, so do we.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != launch.parent) _exit(127);
    setpgid(0, 0);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    signal(SIGPIPE, SIG_DFL);
    signal(SIGTTOU, SIG_IGN);  // a group in the background may write to the terminal
    const bool ready =
        dup2(launch.input, STDIN_FILENO) >= 0 && (launch.output < 0 || dup2(launch.output, STDOUT_FILENO) >= 0) &&
        (launch.errors < 0 || dup2(launch.errors, STDERR_FILENO) >= 0) && (!launch.folder || chdir(launch.folder) == 0);
    if (ready) execvp(launch.words[0], launch.words.data());
    const int problem = errno;
    if (write(launch.failure, &problem, sizeof problem) < 0) _exit(126);
    _exit(127);
}

}  // namespace

Child::Child(const Launch& launch) : id_(fork()) {
    if (id_ < 0) throw Error(std::string("expected to start a program, found: ") + std::strerror(errno));
    if (id_ == 0) become(launch);
    setpgid(id_, id_);  // by both, so that it is a group by the time either goes on
}

Child::~Child() {
    if (!status_) kill_group();
    end();
}

void Child::kill_group() const { kill(-id_, SIGKILL); }

int Child::end() {
    if (status_) return *status_;
    // The group is killed while its id is still ours: after waitpid() another process might have it.
    siginfo_t info;
    while (waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
    }
    kill_group();
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    status_ = status;
    return status;
}

}  // namespace raylab
