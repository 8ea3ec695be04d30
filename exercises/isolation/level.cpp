#include "level.h"

#include "landlock.h"

#include "raylab/base/error.h"

#include <fmt/format.h>
#include <linux/seccomp.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace raylab::grading {

namespace {

bool has_seccomp() {
    const unsigned action = SECCOMP_RET_KILL_PROCESS;
    return syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

}  // namespace

Isolation best_isolation() {
    const int landlock = landlock_version();
    const bool own_user = geteuid() == 0;
    if (!has_seccomp()) return {Level::limits, 0, own_user};
    return {landlock > 0 ? Level::files : Level::system_calls, landlock, own_user};
}

Isolation isolation_at(Level level) {
    Isolation isolation = best_isolation();
    if (isolation.level < level)
        throw Error(fmt::format("expected isolation level {}, found a kernel that offers {}", static_cast<int>(level),
                                to_string(isolation)));
    isolation.level = level;
    if (level < Level::files) isolation.landlock = 0;
    return isolation;
}

std::string to_string(const Isolation& isolation) {
    std::string layers;
    if (isolation.level >= Level::files) layers += fmt::format("Landlock {}, ", isolation.landlock);
    if (isolation.level >= Level::system_calls) layers += "seccomp, ";
    return fmt::format("level {} ({}limits{})", static_cast<int>(isolation.level), layers,
                       isolation.own_user ? ", a user of its own" : "");
}

}  // namespace raylab::grading
