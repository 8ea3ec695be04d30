#pragma once

#include "could_not.h"

#include "raylab/base/process.h"

#include <filesystem>
#include <string>
#include <vector>

// Runs `raylab` by a shell, which closes, redirects and limits its streams and memory.

inline const std::filesystem::path streams_folder = std::filesystem::path(RAYLAB_BUILD) / "tests/streams";
inline const std::string still_life = RAYLAB_SOURCE "/tests/bench/mirror_and_glass.toml";

/// Runs `prefix raylab words... suffix` by sh: in_shell({"help"}, {.suffix = ">/dev/full"}).
struct Around {
    std::string prefix = "", suffix = "";
};
raylab::ProcessResult in_shell(const std::vector<std::string>& words, const Around& around = {});

/// A command with words that keep it short; it prints something.
struct ShortRun {
    std::vector<std::string> words;
    enum class Json { has_option, has_none } json = Json::has_option;
};

/// At least one for each command that `raylab help` lists.
std::vector<ShortRun> short_runs();
