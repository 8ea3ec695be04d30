#include "process_limits.h"

#include <grp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

void checked_call(int result, const char* what) {
    if (result < 0) throw std::system_error(errno, std::generic_category(), what);
}

void set(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
    rlimit now{};
    checked_call(getrlimit(resource, &now), "getrlimit");
    // Who is not root can only lower them.
    const rlimit wanted{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
    checked_call(setrlimit(resource, &wanted), "setrlimit");
}

void set(__rlimit_resource resource, rlim_t most) { set(resource, most, most); }

}  // namespace

void bound(const Limits& limits) {
    set(RLIMIT_CPU, limits.seconds, limits.seconds + 1);  // SIGXCPU, and for who ignores it SIGKILL
    set(RLIMIT_AS, limits.memory);
    set(RLIMIT_FSIZE, limits.file);
    set(RLIMIT_NOFILE, limits.open_files);
    set(RLIMIT_NPROC, limits.processes);
    set(RLIMIT_CORE, 0);
    set(RLIMIT_MEMLOCK, 0);
    set(RLIMIT_MSGQUEUE, 0);
}

void become_user(unsigned id, const fs::path& folder) {
    const auto give = [&](const fs::path& path) { checked_call(lchown(path.c_str(), id, id), "lchown"); };
    give(folder);
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        // What has another name elsewhere is shared (a compiled header), and stays whose it is.
        const bool is_shared = !entry.is_symlink() && entry.is_regular_file() && entry.hard_link_count() > 1;
        if (!is_shared) give(entry.path());
    }
    checked_call(setgroups(0, nullptr), "setgroups");
    checked_call(setresgid(id, id, id), "setresgid");
    checked_call(setresuid(id, id, id), "setresuid");
}

}  // namespace raylab::grading
