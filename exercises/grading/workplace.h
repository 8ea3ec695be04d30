#pragma once

#include "exercise.h"
#include "isolated_process.h"

#include "raylab/base/temporary.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab::grading {

/// A folder of one check's own, removed with it: the student's file, copies of the headers that it may include, and
/// what is made of them. No two checks share a file, so any number of them can run at once.
class Workplace {
public:
    /// `prepared`: a folder with headers that were compiled before (prepared_header.h); empty: there is none.
    Workplace(const Exercise& exercise, const Isolation& isolation, const std::filesystem::path& prepared = {});

    const std::filesystem::path& path() const { return folder_.path(); }
    /// What runs a compiler, or the programs below, with this folder as the only one that they see.
    Isolated isolated() const { return {isolation_, path()}; }
    const Isolation& isolation() const { return isolation_; }

    std::filesystem::path source() const { return path() / (slot_ + ".cpp"); }
    std::filesystem::path assembly() const { return path() / (slot_ + ".s"); }
    std::filesystem::path object() const { return path() / (slot_ + ".o"); }
    std::filesystem::path dependencies() const { return path() / (slot_ + ".d"); }
    std::filesystem::path headers() const { return path() / "include"; }

    /// Programs that contain the student's function: it answers cases, traces a scene, draws its chapter's charts.
    std::filesystem::path program() const { return path() / "answers"; }
    std::filesystem::path tracer() const { return path() / "traced"; }
    std::filesystem::path chapter() const { return path() / "chapter"; }

private:
    ScratchFolder folder_;
    std::string slot_;
    Isolation isolation_;
};

/// The library's headers that a file includes, in its order.
std::vector<std::string> included_headers(const std::filesystem::path& file);

/// The one that every stub includes besides the one that declares its function.
inline constexpr const char* unfinished_header = "raylab/base/unfinished.h";

/// The library's headers that an answer to the exercise may include: those of the stub and of the answers that come
/// with the exercise, and what they include themselves. All others might hold the answer.
std::vector<std::string> visible_headers(const Exercise& exercise);

/// The file in an exercise's folder of a handout that lists them.
inline constexpr const char* headers_file = "headers.txt";

}  // namespace raylab::grading
