#pragma once

#include <span>
#include <string>
#include <string_view>

// Chapters and exercises are folders with a number and a name: "07_recursion", "07b_trace".

namespace raylab {

/// Whether a word of the command line means the folder "07_recursion": "7", "07", "recursion" or the whole, in any
/// letter case.
bool means_folder(std::string_view word, std::string_view folder);

/// The word in quotes, with the folder or its name that it may have been meant for (see with_suggestion()).
std::string with_suggested_folder(std::string_view word, std::span<const std::string> folders);

}  // namespace raylab
