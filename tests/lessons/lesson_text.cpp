#include "lesson_text.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace raylab::lessons {

namespace {

std::vector<std::string> groups(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), pattern); match != std::sregex_iterator(); ++match)
        found.push_back((*match)[1]);
    return found;
}

std::string trimmed(const std::string& line) {
    const auto begin = line.find_first_not_of(' ');
    return begin == std::string::npos ? "" : line.substr(begin);
}

Line::Kind kind_in_fence(const std::string& word) {
    if (word == "pseudo") return Line::Kind::pseudo;
    return word == "math" ? Line::Kind::formula : Line::Kind::other_code;
}

Line::Kind kind_of(const std::string& line) {
    if (line.starts_with("#")) return Line::Kind::heading;
    if (line.starts_with("![")) return Line::Kind::image;
    if (line.starts_with("|")) return Line::Kind::table;
    return line.starts_with("<!--") ? Line::Kind::comment : Line::Kind::text;
}

}  // namespace

const Part* LessonText::part(const std::string& heading) const {
    const auto found = std::ranges::find(parts, heading, &Part::heading);
    return found == parts.end() ? nullptr : &*found;
}

LessonText lesson_text(const std::string& markdown) {
    LessonText lesson{.parts = {{}}};
    std::istringstream lines(markdown);
    bool in_fence = false;
    auto kind = Line::Kind::text;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::string begin = trimmed(line);
        if (begin.starts_with("```")) {
            in_fence = !in_fence;
            if (in_fence) kind = kind_in_fence(begin.substr(3));
            continue;
        }
        if (!in_fence && line.starts_with("# ")) {
            lesson.title = line.substr(2);
            continue;
        }
        if (!in_fence && line.starts_with("## ")) {
            lesson.parts.push_back({line.substr(3), {{line, number, Line::Kind::heading}}});
            continue;
        }
        lesson.parts.back().lines.push_back({line, number, in_fence ? kind : kind_of(begin)});
    }
    return lesson;
}

std::string readable(const Line& line) {
    if (line.kind == Line::Kind::comment || line.kind == Line::Kind::other_code) return "";
    static const std::regex target(R"(\]\([^)]*\))"), code("`[^`]*`"), tag("<[^>]*>");
    const auto without_targets = std::regex_replace(line.text, target, "]");
    if (line.kind == Line::Kind::pseudo) return without_targets;
    return std::regex_replace(std::regex_replace(without_targets, code, " "), tag, " ");
}

std::vector<std::string> formulas(const Line& line) {
    if (line.kind == Line::Kind::formula) return {line.text};
    static const std::regex inline_formula(R"(\$([^$]+)\$)"), code("`[^`]*`");
    if (line.kind == Line::Kind::pseudo || line.kind == Line::Kind::other_code) return {};
    return groups(std::regex_replace(line.text, code, " "), inline_formula);
}

std::vector<std::string> bold(const std::string& text) {
    static const std::regex stars(R"(\*\*([^*]+)\*\*)");
    return groups(text, stars);
}

}  // namespace raylab::lessons
