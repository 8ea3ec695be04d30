#include "raylab/base/temporary.h"

#include "raylab/base/error.h"
#include "raylab/base/lone_users.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <random>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".raylab-";
constexpr std::size_t random_letters = 12;
constexpr std::size_t longest_extension = 16;  // in bytes; every writer's own extension is shorter

std::string new_name(const fs::path& extension) {
    constexpr std::string_view letters = "0123456789abcdefghijklmnopqrstuvwxyz";
    std::random_device random;
    std::uniform_int_distribution<std::size_t> any(0, letters.size() - 1);
    std::string name(prefix);
    for (std::size_t i = 0; i < random_letters; ++i) name += letters[any(random)];
    return extension.native().size() <= longest_extension ? name + extension.native() : name;
}

bool is_temporary_name(const std::string& name) {
    return name.starts_with(prefix) && name.size() >= prefix.size() + random_letters &&
           name.size() <= prefix.size() + random_letters + longest_extension;
}

/// Whether the path still leads to the file that the descriptor has open.
bool leads_to(const fs::path& path, int descriptor) {
    struct stat there {
    }, open{};
    return lstat(path.c_str(), &there) == 0 && fstat(descriptor, &open) == 0 && there.st_dev == open.st_dev &&
           there.st_ino == open.st_ino;
}

void remove_whole(const fs::path& path) noexcept {
    std::error_code left_behind;
    // A thread that still writes may add a file to a folder while it is emptied, so this is tried again.
    for (int tries = 0; tries < 3; ++tries) {
        fs::remove_all(path, left_behind);
        if (!left_behind) return;
    }
}

/// Whether this user made it, or gave it to foreign code: a killed root leaves the folders that such code worked in.
bool is_own(const struct stat& found) {
    return found.st_uid == geteuid() || (geteuid() == 0 && found.st_uid >= first_lone_user);
}

/// Removes the path if nobody holds a lock on it.
void remove_if_abandoned(const fs::path& path) {
    struct stat found {};
    if (lstat(path.c_str(), &found) != 0 || !is_own(found)) return;
    if (!S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode)) return;
    const int opened = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (opened < 0) return;
    const Descriptor file(opened);
    if (flock(file.number(), LOCK_EX | LOCK_NB) == 0 && leads_to(path, file.number())) remove_whole(path);
}

void remove_abandoned(const fs::path& folder) {
    std::error_code unreadable;
    for (fs::directory_iterator entry(folder, unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable))
        if (is_temporary_name(entry->path().filename().string())) remove_if_abandoned(entry->path());
}

[[noreturn]] void throw_cannot_make(const fs::path& path) {
    throw fs::filesystem_error("cannot make a temporary", path, {errno, std::generic_category()});
}

/// Absent where another process removed the folder before it was opened.
std::optional<Descriptor> made(Temporary::Kind kind, const fs::path& path) {
    const bool folder = kind == Temporary::Kind::folder;
    if (folder && mkdir(path.c_str(), 0700) != 0) throw_cannot_make(path);
    const int flags = folder ? O_RDONLY | O_DIRECTORY : O_RDWR | O_CREAT | O_EXCL;
    const int opened = open(path.c_str(), flags | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (opened < 0 && folder && errno == ENOENT) return std::nullopt;
    if (opened < 0) throw_cannot_make(path);
    return Descriptor(opened);
}

/// Creates it and locks it. In between another process may consider it abandoned and remove it: then it is created
/// again. On a file system without locks it stays unlocked, and is never considered abandoned.
Descriptor made_and_locked(Temporary::Kind kind, const fs::path& path) {
    while (true) {
        std::optional<Descriptor> lock = made(kind, path);
        if (!lock) continue;
        flock(lock->number(), LOCK_EX);
        if (leads_to(path, lock->number())) return *std::move(lock);
    }
}

fs::path path_in(const fs::path& folder, const fs::path& extension) {
    remove_abandoned(folder);
    return folder / new_name(extension);
}

fs::path system_folder() {
    std::error_code problem;
    const auto folder = fs::temp_directory_path(problem);
    if (problem) throw Error({"TMPDIR"}, "a folder for temporary files", problem.message());
    return folder;
}

}  // namespace

Temporary::Temporary(Kind kind, const fs::path& folder, const fs::path& extension)
    : Temporary(Uninterrupted(), kind, folder, extension) {}

Temporary::Temporary(const Uninterrupted&, Kind kind, const fs::path& folder, const fs::path& extension)
    : path_(path_in(folder, extension)),
      lock_(made_and_locked(kind, path_)),
      removal_([path = path_] { remove_whole(path); }) {}

Temporary::~Temporary() { remove_whole(path_); }

ScratchFolder::ScratchFolder() try : folder_(Temporary::Kind::folder, system_folder()) {
} catch (const fs::filesystem_error& error) {
    throw Error({system_folder().string()}, "room for a temporary folder", error.code().message());
}

}  // namespace raylab
