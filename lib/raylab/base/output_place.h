#pragma once

#include <filesystem>
#include <optional>

namespace raylab {

/// What stands where an output is to be written, found before any work is done for it.
struct OutputPlace {
    enum class Way {
        replace,  // a regular file, or nothing yet: the new file is renamed onto it
        through   // a device, a FIFO, a file that is our own standard output: it stays, and is written to
    };
    std::filesystem::path named;   // as the user named it
    std::filesystem::path target;  // where symlinks lead
    std::filesystem::path folder;  // the nearest folder that is there, for temporaries
    Way way = Way::replace;
    std::optional<std::filesystem::perms> mode = {};  // of the file that is replaced
    std::optional<int> stream = {};                   // of our own, by its descriptor, where the bytes go through it
};

/// "-" is standard output. Error where nothing can be written: a folder, a read-only file, below what is no folder, a
/// name that is too long.
OutputPlace output_place(const std::filesystem::path& path);

/// A folder that is there or can be made, and may be written; its `target` is where symlinks lead. Error otherwise.
OutputPlace output_folder(const std::filesystem::path& path);

/// Whether both lead to the same file, there or not: by device and inode, or by their canonical paths.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Whether `inner` lies in the folder `outer`, or in one inside it, or would if they were there.
bool lies_in(const std::filesystem::path& inner, const std::filesystem::path& outer);

}  // namespace raylab
