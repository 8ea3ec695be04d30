#pragma once

#include "raylab/base/output_file.h"
#include "raylab/base/output_place.h"
#include "raylab/base/printable.h"
#include "raylab/base/put_in_place.h"
#include "raylab/base/temporary.h"

#include <filesystem>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raylab {

/// A folder whose files are not yet in place.
struct StagedFolder {
    std::filesystem::path path;   // where they are written
    std::filesystem::path named;  // where they will be
};

/// All files that a command writes. They are checked before it begins to work, written as temporaries, and put in place
/// together: without commit() nothing is left of them.
class Outputs {
public:
    struct Plan {
        std::vector<std::filesystem::path> files = {};    // "-" is standard output
        std::vector<std::filesystem::path> folders = {};  // for files whose names are known later
        std::vector<std::filesystem::path> inputs = {};   // must not be replaced
    };

    /// Error for an output that cannot be written, is an input or is another output.
    explicit Outputs(const Plan& plan);

    /// For inputs that are known once another has been read. Error where an output would replace one.
    void keep(const std::vector<std::filesystem::path>& inputs);

    /// One of the plan's files, for a writer.
    OutputFile operator[](const std::filesystem::path& file) { return {file, *this}; }

    void write(const std::filesystem::path& file, std::string_view bytes);

    /// `write` fills a temporary with the file's extension. What it throws names the file.
    void write_with(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write);

    /// A temporary folder that stands for one of the plan's folders: commit() moves what is written there.
    StagedFolder staged(const std::filesystem::path& folder);

    /// Text for people on standard output, printed by commit(); what is not printable in it is shown escaped.
    void say(std::string_view text) { said_ += printable_lines(text); }

    /// Runs `work`, which writes to staged folders; what it throws names the plan's folders instead.
    void naming_folders(const std::function<void()>& work) const;

    /// Writes to devices, FIFOs and standard output, then renames all files to their places. An Error before the first
    /// is renamed leaves none. What is written afterwards waits for the next commit().
    void commit();

private:
    struct Planned {
        explicit Planned(OutputPlace where) : place(std::move(where)) {}
        OutputPlace place;
        std::optional<Temporary> temporary;  // a file's where it replaces another, a folder's once it is asked for
        std::optional<std::string> bytes;    // a file's where it is written through
    };

    void refuse_input(const OutputPlace& place) const;
    void refuse_collision(const OutputPlace& place) const;
    std::vector<CompleteOutput> complete_outputs() const;

    std::list<Planned> files_, folders_;
    std::vector<std::filesystem::path> inputs_;
    std::string said_;
};

}  // namespace raylab
