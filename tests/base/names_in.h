#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace raylab::test {

/// All files and folders below a folder, by their paths from there.
inline std::set<std::string> names_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        names.insert(entry.path().lexically_relative(folder).string());
    return names;
}

}  // namespace raylab::test
