#pragma once

#include <filesystem>
#include <optional>

namespace raylab {

/// What exists at the place of an output, determined before any work is done for it.
struct OutputPlace {
    enum class Way {
        replace,  // a regular file, or nothing yet: the new file is renamed to it
        through   // a device, a FIFO, or a file that is this program's standard output: it is kept and written to
    };
    std::filesystem::path named;   // as the user wrote it
    std::filesystem::path target;  // the target of symlinks
    std::filesystem::path folder;  // the nearest existing folder, for temporary files
    Way way = Way::replace;
    std::optional<std::filesystem::perms> mode = {};  // of the file that is replaced
    // The descriptor of this program's own stream, where the bytes go through it.
    std::optional<int> stream = {};
};

/// Examines a path; "-" is standard output. It throws an Error where nothing can be written: for a folder, a read-only
/// file, a path below something that is no folder, a name that is too long.
OutputPlace output_place(const std::filesystem::path& path);

/// Examines a folder that exists or can be created, and is writable; its `target` is that of symlinks. It throws an
/// Error otherwise.
OutputPlace output_folder(const std::filesystem::path& path);

/// Whether both paths lead to the same file, which need not exist: by device and inode, or by their canonical paths.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Whether `inner` lies in the folder `outer`, or in one inside it, or would if they existed.
bool lies_in(const std::filesystem::path& inner, const std::filesystem::path& outer);

}  // namespace raylab
