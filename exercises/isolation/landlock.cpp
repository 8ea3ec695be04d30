#include "landlock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <iterator>
#include <system_error>

namespace raylab::grading {

namespace {

// <linux/landlock.h> of Debian 12 knows version 2; these are the names and numbers of version 6.
constexpr unsigned version_question = 1;  // LANDLOCK_CREATE_RULESET_VERSION
constexpr int rule_of_path = 1;           // LANDLOCK_RULE_PATH_BENEATH
constexpr std::uint64_t execute = 1 << 0, write_file = 1 << 1, read_file = 1 << 2, read_folder = 1 << 3,
                        truncate = 1 << 14, control_device = 1 << 15;
constexpr std::uint64_t of_files = execute | write_file | read_file | truncate | control_device;

struct Ruleset {
    std::uint64_t files = 0, network = 0, scopes = 0;
};

struct [[gnu::packed]] PathRule {
    std::uint64_t allowed;
    int folder;
};

// What each version can close. The kernel takes a structure that ends where the version's does.
Ruleset all_of(int version) {
    constexpr int last_file_right[] = {13, 13, 14, 15, 15, 16};  // versions 0 (none) and 1 to 5
    const auto rights = last_file_right[std::min<std::size_t>(static_cast<std::size_t>(version), 5)];
    return {.files = (std::uint64_t{1} << rights) - 1,
            .network = version >= 4 ? 3u : 0u,  // bind and connect TCP
            .scopes = version >= 6 ? 3u : 0u};  // abstract sockets, signals
}

std::size_t size_of(int version) {
    return version >= 6 ? sizeof(Ruleset) : (version >= 4 ? 2 : 1) * sizeof(std::uint64_t);
}

int checked(long result, const char* what) {
    if (result < 0) throw std::system_error(errno, std::generic_category(), what);
    return static_cast<int>(result);
}

void open_path(int rules, const std::filesystem::path& path, std::uint64_t rights, std::uint64_t known) {
    const int opened = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (opened < 0) return;  // what is not there needs no right
    struct stat found {};
    checked(fstat(opened, &found), "fstat");
    if (!S_ISDIR(found.st_mode)) rights &= of_files;
    const PathRule rule{rights & known, opened};
    const long added = syscall(SYS_landlock_add_rule, rules, rule_of_path, &rule, 0);
    close(opened);
    checked(added, "landlock_add_rule");
}

}  // namespace

int landlock_version() {
    const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, version_question);
    return version < 0 ? 0 : static_cast<int>(version);
}

void close_other_files(const OpenFiles& open) {
    const int version = landlock_version();
    const Ruleset all = all_of(version);
    const int rules =
        checked(syscall(SYS_landlock_create_ruleset, &all, size_of(version), 0), "landlock_create_ruleset");
    for (const auto& path : open.readable) open_path(rules, path, execute | read_file | read_folder, all.files);
    for (const auto& path : open.writable) open_path(rules, path, all.files, all.files);
    checked(syscall(SYS_landlock_restrict_self, rules, 0), "landlock_restrict_self");
    close(rules);
}

}  // namespace raylab::grading
