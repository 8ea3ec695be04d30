#pragma once

#include <string>
#include <vector>

// A chapter's README.md as the tests see it: parts, and what each line is.

namespace raylab::lessons {

/// A line of a lesson's text, and where it stands.
struct Line {
    std::string text;
    int number;  // in the file, from 1
    enum class Kind { text, heading, image, table, pseudo, formula, other_code, comment } kind = Kind::text;
};

/// A part of a lesson, below a heading of the second level.
struct Part {
    std::string heading;  // empty: what stands before the first one
    std::vector<Line> lines;
};

struct LessonText {
    std::string title;        // without "# "
    std::vector<Part> parts;  // the first is the introduction

    /// The part with this heading; none where it is missing.
    const Part* part(const std::string& heading) const;
};

LessonText lesson_text(const std::string& markdown);

/// What a reader reads of a line: words without links' targets, code, comments and tags; formulas stay.
std::string readable(const Line& line);

/// The formulas of a line: what stands between dollars, or the whole line of a displayed one.
std::vector<std::string> formulas(const Line& line);

/// What stands in bold.
std::vector<std::string> bold(const std::string& text);

}  // namespace raylab::lessons
