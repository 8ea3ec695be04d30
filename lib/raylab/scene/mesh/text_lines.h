#pragma once

#include "raylab/base/error.h"
#include "raylab/geometry/vector.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// A word of a file as a message shows it: in quotes, printable, short.
std::string in_quotes(std::string_view word);

/// How a text format treats its lines before they are split into words.
struct TextLayout {
    char comment = '\0';  // begins a comment to the end of the line; '\0': the format has no comments
    enum class Backslash { is_text, joins_lines } backslash = Backslash::is_text;  // at the end of a line
};

/// Goes through the lines of a text file that are not empty, split into words at blanks. A line ends with \n, \r\n or
/// \r.
class TextLines {
public:
    TextLines(std::string_view bytes, std::string file, TextLayout layout = {});

    /// Goes to the next line that holds a word; false at the end of the file.
    bool next();
    /// Goes to the next line where the format demands one; throws an Error where there is none.
    void expect_next(std::string_view what);
    /// Throws an Error where anything follows.
    void expect_end();

    const std::vector<std::string_view>& words() const { return words_; }
    std::size_t bytes_left() const { return bytes_.size() - next_; }
    Place place() const { return {file_, line_}; }

    /// The word as the nearest float. It throws an Error where the word is no finite number, or too large for a float.
    float number(std::size_t word) const;
    /// Three words as floats.
    Vec3f vector(std::size_t first_word) const;
    std::int64_t integer(std::size_t word) const;
    /// Throws an Error that says what the line should hold and which word was found.
    [[noreturn]] void refuse(const std::string& expected, std::size_t word = 0) const;
    /// Throws an Error that shows the whole line.
    [[noreturn]] void refuse_line(const std::string& expected) const;

private:
    std::string_view take_line();
    void split(std::string_view line);

    std::string_view bytes_;
    std::string file_;
    TextLayout layout_;
    std::size_t next_ = 0;  // the offset of the lines that are not yet read
    int line_ = 1;
    int next_line_ = 1;
    std::vector<std::string_view> words_;
};

}  // namespace raylab
