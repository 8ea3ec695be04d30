#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

// A student's file as text: what of it the compiler gets, what it may include, and what the compiler says of it.

namespace raylab::grading {

inline constexpr std::size_t largest_source = 1 << 20;  // bytes; an answer has a thousandth of that

/// The file's text without a byte order mark, with \n at the ends of lines, whatever the editor wrote. It throws an
/// Error where there is no such file, or a larger one.
std::string source_text(const std::filesystem::path& file);

/// A sentence for each directive that asks for a file which no answer needs: by an absolute path, through "..", a
/// source file, or by a name that only the preprocessor knows.
std::vector<std::string> faults_of_directives(const std::string& text);

/// The files that a compiled file included, from what `-MD` wrote.
std::vector<std::filesystem::path> included_files(const std::filesystem::path& dependencies);

/// A sentence for each of them that is neither in this folder nor of the compiler, the C library or GLM.
std::vector<std::string> faults_of_includes(const std::vector<std::filesystem::path>& included,
                                            const std::filesystem::path& headers);

/// The first lines of what the compiler says, with the student's own file in place of the copy that was compiled.
std::string shown_messages(const std::string& messages, const std::filesystem::path& copy,
                           const std::filesystem::path& file);

/// Whether the compiler looked for a header that it does not see.
bool asks_for_other_headers(const std::string& messages);

}  // namespace raylab::grading
