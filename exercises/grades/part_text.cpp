#include "part_text.h"

#include "raylab/base/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace raylab::grading {

namespace {

std::string below(const std::string& title, const std::string& text) {
    if (text.empty()) return {};
    std::istringstream lines(text);
    std::string block = "\n" + title + "\n";
    for (std::string line; std::getline(lines, line);) block += "    " + line + "\n";
    return block;
}

std::string wrong_answer_text(const FirstWrong& wrong) {
    return fmt::format("{}\nexpected   {}\ngot        {}\n", wrong.story, wrong.expected, wrong.got);
}

}  // namespace

std::string safe_text(const std::string& text, std::size_t longest) {
    constexpr std::string_view cut = "...";
    std::string safe = printable_lines(text);
    if (safe.size() <= longest) return safe;
    std::size_t end = longest - cut.size();
    while (end > 0 && (static_cast<unsigned char>(safe[end]) & 0xc0) == 0x80) --end;
    return safe.substr(0, end).append(cut);
}

std::string whole_text(const Grade& grade) {
    std::string text = grade.summary + "\n";
    for (const auto& note : grade.submitted.notes) text += note + "\n";
    text += below("The compiler:", grade.compiler);
    if (grade.details != grade.summary) text += below("How it ended:", grade.details);
    if (grade.first_wrong)
        text += below(
            fmt::format("The first wrong answer (case {}, {}):", grade.first_wrong->index, grade.first_wrong->group),
            wrong_answer_text(*grade.first_wrong));
    text += below("What is probably wrong:", grade.hint);
    text += below("It printed:", grade.printed);
    return text;
}

std::string part_text(const Grade& grade, const GradePart& part) {
    const auto text = part.message.empty() ? grade.summary : part.message;
    if (part.passed() || !grade.first_wrong || grade.first_wrong->group != part.name) return text;
    return text + ". The first wrong answer:\n" + wrong_answer_text(*grade.first_wrong);
}

std::string part_text_with_whole(const Grade& grade, const GradePart& part) {
    const auto first = std::ranges::find_if_not(grade.parts, &GradePart::passed);
    if (first == grade.parts.end() || first->name != part.name) return part_text(grade, part);
    return (part.message.empty() || part.message == grade.summary ? "" : part.message + "\n") + whole_text(grade);
}

std::string conditions_text(const Grade& grade) {
    std::string text = grade.seed ? fmt::format("seed {}", *grade.seed) : "no seed";
    text += grade.isolation ? ", isolation " + to_string(*grade.isolation) : "";
    return text +
           fmt::format(", compiled in {:.1f} s, answered in {:.2f} s", grade.compile_seconds, grade.answer_seconds);
}

}  // namespace raylab::grading
