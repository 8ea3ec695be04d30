#pragma once

#include "raylab/base/output_file.h"
#include "raylab/base/output_place.h"
#include "raylab/base/print.h"
#include "raylab/base/put_in_place.h"
#include "raylab/base/temporary.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raylab {

/// A folder whose files are not yet at their final place.
struct StagedFolder {
    std::filesystem::path path;   // where the files are written
    std::filesystem::path named;  // where they will be moved
};

/// All files that a command writes. They are checked before it starts to work, written as temporary files, and moved to
/// their places together: without commit() all of them are removed.
class Outputs {
public:
    struct Plan {
        std::vector<std::filesystem::path> files = {};    // "-" is standard output
        std::vector<std::filesystem::path> folders = {};  // for files whose names are known later
        // Files that must not be replaced, and folders into which nothing must be put.
        std::vector<std::filesystem::path> inputs = {};
    };

    /// Throws an Error for an output that cannot be written, is an input or is another output.
    explicit Outputs(const Plan& plan);

    /// Adds inputs that are known only after another was read. It throws an Error where an output would replace one.
    void keep(const std::vector<std::filesystem::path>& inputs);

    /// One of the planned files, for a writer.
    OutputFile operator[](const std::filesystem::path& file) { return {file, *this}; }

    /// Whether each commit() replaces this file. Where it does not, as in a FIFO, one commit's bytes follow another's.
    bool replaces(const std::filesystem::path& file) const;

    void write(const std::filesystem::path& file, std::string_view bytes);

    /// `write` fills a temporary file with the file's extension. An Error that it throws names the file.
    void write_with(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write);

    /// A temporary folder that stands for one of the planned folders: commit() moves the files that were written there.
    StagedFolder staged(const std::filesystem::path& folder);

    /// The size of one of the planned files as it is now, in bytes.
    std::uintmax_t size(const std::filesystem::path& file);

    /// Text for people on standard output, which commit() prints as print_text() does.
    void say(std::string_view text) { said_ += shown_text(text); }

    /// Runs `work`, which writes to staged folders; Errors that it throws name the planned folders instead.
    void naming_folders(const std::function<void()>& work) const;

    /// Writes to devices, FIFOs and standard output, then renames all files to their places. An Error before the first
    /// is renamed leaves none. Files that are written afterwards wait for the next commit().
    void commit();

private:
    struct Planned {
        explicit Planned(OutputPlace where) : place(std::move(where)) {}
        OutputPlace place;
        std::optional<Temporary> temporary;  // of a file that replaces another, or of a folder once it is asked for
        std::optional<std::string> bytes;    // of a file that is written directly
    };

    void refuse_input(const OutputPlace& place) const;
    void refuse_collision(const OutputPlace& place) const;
    std::vector<CompleteOutput> complete_outputs() const;

    std::list<Planned> files_, folders_;
    std::vector<std::filesystem::path> inputs_;
    std::string said_;
};

}  // namespace raylab
