#pragma once

#include "raylab/base/file.h"

#include <stdlib.h>

#include <filesystem>
#include <string>

/// While it exists, the PATH has a shell script before any program of that name.
class OnPath {
public:
    OnPath(const std::filesystem::path& folder, const std::string& program, const std::string& script)
        : path_(getenv("PATH")) {
        raylab::write_file(folder / program, "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(folder / program, std::filesystem::perms::owner_all);
        setenv("PATH", (folder.string() + ":" + path_).c_str(), 1);
    }
    OnPath(const OnPath&) = delete;
    OnPath& operator=(const OnPath&) = delete;
    ~OnPath() { setenv("PATH", path_.c_str(), 1); }

private:
    std::string path_;
};
