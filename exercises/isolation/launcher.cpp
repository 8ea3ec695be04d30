#include "launcher.h"
#include "landlock.h"
#include "level.h"
#include "process_limits.h"
#include "system_calls.h"

#include "raylab/base/lone_users.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

// The program between a check and foreign code: it lays all bounds on itself and becomes the program that is named
// after them (isolated_process.h writes its words). The order is that of what each step still needs: files before
// Landlock, system calls before the filter.

namespace {

using namespace raylab::grading;
namespace fs = std::filesystem;

Work work_from(const std::string& word) {
    for (std::size_t i = 0; i < words_for_work.size(); ++i)
        if (word == words_for_work[i]) return static_cast<Work>(i);
    throw std::invalid_argument("expected a kind of work, found " + word);
}

Limits limits_of(Work work, unsigned seconds) {
    constexpr std::uint64_t megabyte = 1 << 20;
    switch (work) {
        case Work::compile:  // a stub takes 300 MB
            return {.seconds = seconds, .memory = 2048 * megabyte, .file = 64 * megabyte, .processes = 64};
        case Work::draw:
        case Work::render:
            return {.seconds = seconds, .memory = 4096 * megabyte, .file = 64 * megabyte, .processes = 64};
        default:  // an answer takes next to no memory
            return {.seconds = seconds, .memory = 1024 * megabyte, .file = 0, .processes = 64};
    }
}

OpenFiles files_of(Work work, const fs::path& folder, const fs::path& program) {
    const std::vector<fs::path> libraries{"/usr/lib", "/lib", "/lib64", "/etc/ld.so.cache"};
    OpenFiles open{.readable = {program}, .writable = {}};
    if (work != Work::answer) open.readable.insert(open.readable.end(), libraries.begin(), libraries.end());
    if (work == Work::load_and_answer || work == Work::answer) return open;
    open.writable = {folder, "/dev/null"};
    if (work == Work::render) {
        open.readable.insert(open.readable.end(), {"/usr", "/bin", "/proc/cpuinfo", "/sys/devices/system/cpu"});
        return open;
    }
    if (work == Work::draw) {
        open.readable.insert(open.readable.end(),
                             {"/usr", "/bin", "/etc", "/proc", "/sys", RAYLAB_SOURCE, RAYLAB_BUILD});
        return open;
    }
    open.readable.insert(open.readable.end(), {"/usr/bin", "/usr/libexec", "/usr/include", "/bin"});
    return open;
}

void isolate(Level level, Work work, unsigned seconds, const fs::path& folder, const fs::path& program) {
    close_range(STDERR_FILENO + 1, ~0u, 0);
    bound(limits_of(work, seconds));
    if (geteuid() == 0) become_user(raylab::first_lone_user + static_cast<unsigned>(getpid()), folder);
    // Setting a user clears it.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        throw std::system_error(errno, std::generic_category(), "PR_SET_NO_NEW_PRIVS");
    if (level >= Level::files) close_other_files(files_of(work, folder, program));
    if (level >= Level::system_calls) filter_system_calls(work);
}

}  // namespace

int main(int count, char** words) {
    constexpr int level_at = 1, work_at = 2, seconds_at = 3, folder_at = 4, program_at = 5;
    if (count <= program_at) return exit_not_isolated;
    try {
        const fs::path folder = words[folder_at];
        std::string home = "HOME=" + folder.string(), scratch = "TMPDIR=" + folder.string();
        std::string path = "PATH=/usr/bin:/bin", language = "LC_ALL=C.UTF-8";
        char* environment[] = {home.data(), scratch.data(), path.data(), language.data(), nullptr};
        isolate(static_cast<Level>(std::stoi(words[level_at])), work_from(words[work_at]),
                static_cast<unsigned>(std::stoul(words[seconds_at])), folder, words[program_at]);
        execve(words[program_at], words + program_at, environment);
        throw std::system_error(errno, std::generic_category(), words[program_at]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cannot isolate the program: %s\n", error.what());
        return exit_not_isolated;
    }
}
