#include "formats.h"
#include "part_text.h"

#include <fmt/format.h>

#include <sstream>

// https://testanything.org/tap-version-14-specification.html

namespace raylab::grading {

namespace {

// A description ends at a number sign, and a line is one test.
std::string description(const std::string& text) {
    std::string line;
    for (const char character : safe_text(text, longest_message)) {
        if (character == '#' || character == '\\') line += '\\';
        line += character == '\n' || character == '\t' ? ' ' : character;
    }
    return line;
}

// A text of several lines as YAML keeps it: indented, with nothing in it that means something.
std::string yaml_block(const std::string& name, const std::string& text) {
    std::istringstream lines(safe_text(text, longest_message));
    std::string block = "  " + name + ": |2\n";
    for (std::string line; std::getline(lines, line);) block += "    " + line + "\n";
    return block;
}

}  // namespace

std::string as_tap(const Grade& grade) {
    std::string text = fmt::format("TAP version 14\n1..{}\n", grade.parts.size());
    std::size_t number = 0;
    for (const auto& part : grade.parts) {
        text += fmt::format("{} {} - {}\n", part.passed() ? "ok" : "not ok", ++number, description(part.name));
        if (part.passed()) continue;
        text += fmt::format("  ---\n  verdict: {}\n  points: {}\n  max_points: {}\n", to_string(grade.outcome),
                            points_text(part.points), points_text(part.most)) +
                yaml_block("message", part_text_with_whole(grade, part)) + "  ...\n";
    }
    if (grade.outcome == Outcome::internal) return text + "Bail out! " + description(grade.summary) + "\n";
    return text + fmt::format("# {} of {} points; {}\n", points_text(grade.points()), points_text(grade.most),
                              description(conditions_text(grade)));
}

}  // namespace raylab::grading
