#include "directives.h"

#include "without_comments.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string_view>

namespace raylab::grading {

namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\f\v";
    const auto begin = text.find_first_not_of(blanks);
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

// What stands behind the sign that begins a directive, # or the digraph for it.
std::optional<std::string_view> directive_in(std::string_view line) {
    line = trimmed(line);
    for (const std::string_view sign : {"#", "%:"})
        if (line.starts_with(sign)) return trimmed(line.substr(sign.size()));
    return std::nullopt;
}

}  // namespace

std::vector<std::string> included_names(const std::string& text) {
    constexpr std::array<std::string_view, 3> including{"include", "include_next", "import"};
    std::istringstream lines(without_comments(text));
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        const auto directive = directive_in(line).value_or("");
        const auto word = directive.substr(0, directive.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"));
        if (std::ranges::find(including, word) != including.end())
            names.emplace_back(trimmed(directive.substr(word.size())));
    }
    return names;
}

}  // namespace raylab::grading
