#pragma once

#include <filesystem>
#include <string>

namespace raylab {

/// Lines of a source file.
struct Excerpt {
    std::string text;  // without the indentation that all its lines share
    int first_line = 0, last_line = 0;
};

/// The most lines that an excerpt may have, so that it fits a slide.
inline constexpr int longest_excerpt = 25;

/// The lines from the one that contains `begin` to the end of what begins there: the first later line that begins with
/// a closing brace at the same indentation. It throws an Error where not exactly one line contains `begin`, where there
/// is no such end, and where the lines are too many.
Excerpt excerpt(const std::filesystem::path& source, const std::string& begin);

}  // namespace raylab
