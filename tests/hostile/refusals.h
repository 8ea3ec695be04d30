#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// A file that must be refused, and what the message must contain.
struct Refusal {
    std::filesystem::path file;
    std::string fragment;
};

/// The lines of folder/expected.txt: "file | fragment"; blank lines and # comments apart.
std::vector<Refusal> refusals(const std::filesystem::path& folder);

/// Checks that `read` throws Error for each file of the folder's table, on one line that contains the fragment, and
/// that every file directly in the folder stands in the table.
void check_refusals(const std::filesystem::path& folder, const std::function<void(const std::filesystem::path&)>& read);
