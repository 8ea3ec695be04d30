#pragma once

#include "raylab/base/descriptor.h"
#include "raylab/base/interrupt.h"

#include <filesystem>
#include <string>

namespace raylab {

/// A file or folder that is removed with its owner and by an interrupt. It is locked while it exists, so that the next
/// one in the same folder can recognise, and remove, those that a killed process left behind.
class Temporary {
public:
    enum class Kind { file, folder };

    /// Creates one in `folder`. Its name is short, whatever it stands for, and ends in `extension` if that is short. It
    /// throws std::filesystem::filesystem_error where it fails.
    Temporary(Kind kind, const std::filesystem::path& folder, const std::filesystem::path& extension = {});
    ~Temporary();
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    Temporary(const Uninterrupted& while_made, Kind kind, const std::filesystem::path& folder,
              const std::filesystem::path& extension);

    std::filesystem::path path_;
    Descriptor lock_;
    AtInterrupt removal_;
};

/// A folder for intermediate files, where the system has such folders (TMPDIR or /tmp).
class ScratchFolder {
public:
    ScratchFolder();
    const std::filesystem::path& path() const { return folder_.path(); }

private:
    Temporary folder_;
};

}  // namespace raylab
