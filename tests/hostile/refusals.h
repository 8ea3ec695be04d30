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

/// The lines "file | fragment" of folder/expected.txt, without blank lines and # comments.
std::vector<Refusal> refusals(const std::filesystem::path& folder);

/// Checks that `read` throws an Error for each file of the folder's table, on one line that contains the fragment, and
/// that every file directly in the folder is in the table.
void check_refusals(const std::filesystem::path& folder, const std::function<void(const std::filesystem::path&)>& read);
