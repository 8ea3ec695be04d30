#include "lesson_form.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <sstream>

namespace raylab::lessons {

namespace {

constexpr std::array late_parts{
    "Speed against accuracy",     "Where it fails", "Deeper", "Try this", "Questions", "Summary", "Words and symbols",
    "Sources and further reading"};

bool is_late(const std::string& heading) { return std::ranges::find(late_parts, heading) != late_parts.end(); }

std::string where(const Line& line) { return "line " + std::to_string(line.number) + ": "; }

// How many lines of a part match a pattern.
std::size_t count(const Part* part, const std::string& pattern) {
    if (!part) return 0;
    const std::regex expected(pattern);
    return static_cast<std::size_t>(
        std::ranges::count_if(part->lines, [&](const Line& line) { return std::regex_search(line.text, expected); }));
}

const std::regex& whole_figure() {
    static const std::regex figure(R"(!\[.+\]\((pictures/[a-z0-9_/]+\.(png|svg))\))");
    return figure;
}

}  // namespace

Complaints title_complaints(const LessonText& lesson, const std::string& number, const std::string& title,
                            const std::string& question) {
    std::string expected = question;
    expected[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(expected[0])));
    expected = number + " " + title + ": " + expected;
    if (lesson.title == expected) return {};
    return {"expected the title '" + expected + "', found '" + lesson.title + "'"};
}

Complaints part_complaints(const LessonText& lesson) {
    Complaints complaints;
    constexpr std::size_t fewest = 4, most = 9;
    std::size_t core = 0;
    while (core + 1 < lesson.parts.size() && !is_late(lesson.parts[core + 1].heading)) ++core;
    if (core < fewest || core > most)
        complaints.push_back("expected " + std::to_string(fewest) + " to " + std::to_string(most) +
                             " sections before '" + late_parts[0] + "', found " + std::to_string(core));
    std::vector<std::string> late;
    for (std::size_t i = core + 1; i < lesson.parts.size(); ++i) late.push_back(lesson.parts[i].heading);
    for (std::size_t i = 0; i < std::max(late.size(), late_parts.size()); ++i) {
        const std::string expected = i < late_parts.size() ? late_parts[i] : "nothing more";
        const std::string found = i < late.size() ? late[i] : "nothing";
        if (expected == found) continue;
        complaints.push_back("expected the part '" + expected + "', found '" + found + "'");
        break;
    }
    return complaints;
}

std::size_t core_words(const LessonText& lesson) {
    std::size_t words = 0;
    bool folded = false;
    for (const Part& part : lesson.parts) {
        if (is_late(part.heading)) break;
        for (const Line& line : part.lines) {
            if (line.text.find("<details>") != std::string::npos) folded = true;
            if (line.text.find("</details>") != std::string::npos) folded = false;
            if (folded || (line.kind != Line::Kind::text && line.kind != Line::Kind::heading)) continue;
            std::istringstream text(readable(line));
            for (std::string word; text >> word;)
                words += std::ranges::any_of(word, [](unsigned char c) { return std::isalnum(c) != 0; });
        }
    }
    return words;
}

Complaints question_complaints(const LessonText& lesson) {
    const Part* part = lesson.part("Questions");
    Complaints complaints;
    const auto expect_three = [&](const std::string& what, const std::string& pattern) {
        if (const auto found = count(part, pattern); found != 3)
            complaints.push_back("expected three " + what + ", found " + std::to_string(found));
    };
    expect_three("questions that begin in bold", R"(^\d\. \*\*)");
    expect_three("questions that end in a bold question mark", R"(\?\*\*$)");  // some go over two lines
    expect_three("folded answers", R"(^ *<details><summary>Answer</summary>$)");
    expect_three("answers that begin in bold", R"(^ +\*\*)");
    return complaints;
}

Complaints experiment_complaints(const LessonText& lesson) {
    const auto found = count(lesson.part("Try this"), R"(^(\d\.|-) )");
    if (found == 3) return {};
    return {"expected three experiments, found " + std::to_string(found)};
}

Complaints summary_complaints(const LessonText& lesson) {
    const auto found = count(lesson.part("Summary"), "^- ");
    if (found >= 3 && found <= 6) return {};
    return {"expected a summary of three to six points, found " + std::to_string(found)};
}

Complaints figure_complaints(const LessonText& lesson) {
    Complaints complaints;
    for (const Part& part : lesson.parts)
        for (const Line& line : part.lines)
            if (line.kind == Line::Kind::image && !std::regex_match(line.text, whole_figure()))
                complaints.push_back(where(line) + "expected ![caption](pictures/NAME.png), found " + line.text);
    return complaints;
}

Complaints numbering_complaints(const LessonText& lesson) {
    static const std::regex tag(R"(\\tag\{(\w+)\})");
    Complaints complaints;
    int last = 0;
    for (const Part& part : lesson.parts)
        for (const Line& line : part.lines)
            if (std::smatch match; std::regex_search(line.text, match, tag) && match[1] != std::to_string(++last))
                complaints.push_back(where(line) + "expected formula (" + std::to_string(last) + "), found (" +
                                     match[1].str() + ")");
    return complaints;
}

std::vector<std::string> figure_files(const LessonText& lesson) {
    std::vector<std::string> files;
    for (const Part& part : lesson.parts)
        for (const Line& line : part.lines)
            if (std::smatch match; line.kind == Line::Kind::image && std::regex_match(line.text, match, whole_figure()))
                files.push_back(match[1]);
    return files;
}

}  // namespace raylab::lessons
