#include "raylab/base/output_place.h"

#include "raylab/base/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <system_error>

namespace raylab {

namespace fs = std::filesystem;

namespace {

using Way = OutputPlace::Way;

std::optional<struct stat> file_there(const fs::path& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) return std::nullopt;
    return found;
}

bool is_same(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

/// The path without symlinks and dots, as far as it exists.
fs::path resolved(const fs::path& path) {
    std::error_code unreadable;
    const auto found = fs::weakly_canonical(fs::absolute(path), unreadable);
    return unreadable ? fs::absolute(path).lexically_normal() : found;
}

/// The target of a chain of symlinks, which need not exist.
fs::path without_links(const fs::path& named) {
    constexpr int max_links = 40;  // as many as Linux follows
    fs::path path = named;
    for (int links = 0; links < max_links; ++links) {
        std::error_code problem;
        const auto status = fs::symlink_status(path, problem);
        if (status.type() == fs::file_type::none)
            throw Error({named.string()}, "a place that can be written", problem.message());
        if (!fs::is_symlink(status)) return path;
        path = path.parent_path() / fs::read_symlink(path);
    }
    throw Error({named.string()}, "symlinks that lead somewhere", "a circle of them");
}

void refuse_long_names(const fs::path& target, const fs::path& named) {
    const auto is_long = [](const fs::path& name) { return name.native().size() > NAME_MAX; };
    const auto found = std::ranges::find_if(target, is_long);
    if (found == target.end()) return;
    throw Error({named.string()}, "names of at most " + std::to_string(NAME_MAX) + " bytes",
                "one of " + std::to_string(found->native().size()));
}

void refuse_unwritable(const fs::path& path, const fs::path& named) {
    if (faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0) return;
    throw Error({named.string()}, "a place that can be written", path.string() + ": " + std::strerror(errno));
}

/// The folder itself, or the nearest existing one above it, which must permit new files.
fs::path nearest_folder(fs::path folder, const fs::path& named) {
    if (folder.empty()) folder = ".";
    std::error_code problem;
    auto status = fs::status(folder, problem);
    while (status.type() == fs::file_type::not_found) {
        folder = folder.has_parent_path() && folder.parent_path() != folder ? folder.parent_path() : fs::path(".");
        status = fs::status(folder, problem);
    }
    if (status.type() == fs::file_type::none)
        throw Error({named.string()}, "a place that can be written", problem.message());
    if (!fs::is_directory(status))
        throw Error({named.string()}, "a folder to write in", folder.string() + ", which is none");
    refuse_unwritable(folder, named);
    return folder;
}

/// Whether standard output or standard error is redirected to this regular file: replacing the file would lose what is
/// printed.
std::optional<int> own_stream(const struct stat& file) {
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        struct stat open {};
        if (S_ISREG(file.st_mode) && fstat(stream, &open) == 0 && is_same(open, file)) return stream;
    }
    return std::nullopt;
}

}  // namespace

OutputPlace output_place(const fs::path& path) {
    if (!path.has_filename())
        throw Error({path.string()}, "a file's name to write to", path.empty() ? "none" : "a folder's");
    if (path == "-") return {.named = path, .target = path, .folder = {}, .way = Way::through, .stream = STDOUT_FILENO};
    const auto there = file_there(path);
    if (there && S_ISDIR(there->st_mode)) throw Error({path.string()}, "a file to write to", "a folder");
    // Root may write to a file without write permission, but whoever removed the permission meant to keep the file.
    if (there && (there->st_mode & S_IWUSR) == 0)
        throw Error({path.string()}, "a file that may be written", "a read-only one");
    if (there) refuse_unwritable(path, path);
    const auto stream = there ? own_stream(*there) : std::nullopt;
    if (there && (stream || !S_ISREG(there->st_mode)))
        return {.named = path, .target = path, .folder = {}, .way = Way::through, .stream = stream};
    const auto target = without_links(path);
    refuse_long_names(target, path);
    OutputPlace place{.named = path, .target = target, .folder = nearest_folder(target.parent_path(), path)};
    if (there) place.mode = static_cast<fs::perms>(there->st_mode & 07777);
    return place;
}

OutputPlace output_folder(const fs::path& path) {
    const auto folder = path.has_filename() ? path : path.parent_path();
    const auto target = without_links(folder.empty() ? fs::path(".") : folder);
    refuse_long_names(target, path);
    return {.named = path, .target = target, .folder = nearest_folder(target, path)};
}

bool same_file(const fs::path& a, const fs::path& b) {
    const auto there_a = file_there(a), there_b = file_there(b);
    if (there_a && there_b) return is_same(*there_a, *there_b);
    if (there_a || there_b) return false;
    return resolved(a) == resolved(b);
}

bool lies_in(const fs::path& inner, const fs::path& outer) {
    const auto place = fs::weakly_canonical(fs::absolute(inner).parent_path());  // "a/../b" does not lie in a
    for (auto folder = place; folder.has_relative_path(); folder = folder.parent_path())
        if (same_file(folder, outer)) return true;
    return false;
}

}  // namespace raylab
