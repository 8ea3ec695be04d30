#pragma once

#include "raylab/base/process.h"
#include "raylab/base/temporary.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// A folder with input files for every command: scene.toml with mesh.off, tree.json, other.json, a.png, b.png, rays,
/// replay.json, answer.cpp, course.key. The commands run in it.
class Workplace {
public:
    Workplace();

    const std::filesystem::path& path() const { return folder_.path(); }

    /// Runs `raylab` with the words; `output` replaces OUTPUT among them.
    raylab::ProcessResult lab(std::vector<std::string> words, const std::string& output = {}) const;

    /// All names in the folder, with the permissions, and the bytes or the link, of each.
    std::map<std::string, std::string> contents() const;

private:
    raylab::ScratchFolder folder_;
};

/// The words as they are typed.
std::string words_of(const std::vector<std::string>& words);
