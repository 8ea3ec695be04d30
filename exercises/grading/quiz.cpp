#include "quiz.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/scene/toml/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

namespace raylab::grading {

namespace {

using toml_file::Value;

const std::filesystem::path quiz_source = RAYLAB_SOURCE;
constexpr double close_enough = 0.02;  // relative: "about 1.5 m"

// The section of a lesson between two headings.
std::string section(const std::string& lesson, const std::string& heading) {
    const auto begin = lesson.find("\n## " + heading + "\n");
    if (begin == std::string::npos) return {};
    const auto end = lesson.find("\n## ", begin + 1);
    return lesson.substr(begin, end == std::string::npos ? end : end - begin);
}

// A question begins "1. **", its answer stands in <details>.
std::vector<QuizQuestion> questions_in(const std::string& lesson) {
    static const std::regex item(
        R"re(\n\d\. \*\*([\s\S]*?)\*\*\s*<details><summary>Answer</summary>([\s\S]*?)</details>)re");
    const auto text = section(lesson, "Questions");
    std::vector<QuizQuestion> all;
    for (std::sregex_iterator match(text.begin(), text.end(), item), end; match != end; ++match)
        all.push_back({.asks = plain_text((*match)[1]), .answer = plain_text((*match)[2])});
    return all;
}

template <class T>
const T* in_table(const Value& table, const std::string& key) {
    const auto* entry = toml_file::find(std::get<Value::Table>(table.data), key);
    return entry ? std::get_if<T>(&entry->value.data) : nullptr;
}

std::string text_of(const Value& table, const std::string& key, const std::string& file) {
    const auto* text = in_table<std::string>(table, key);
    if (!text) throw Error({file, table.line}, "a text '" + key + "'", "none");
    return *text;
}

void add_answer(QuizQuestion& question, const Value& entry, const std::string& file) {
    if (const auto* number = in_table<double>(entry, "number")) question.number = *number;
    if (const auto* number = in_table<std::int64_t>(entry, "number")) question.number = static_cast<double>(*number);
    const auto* choices = in_table<Value::Array>(entry, "choices");
    if (!choices) return;
    for (const auto& choice : *choices) question.choices.push_back(std::get<std::string>(choice.data));
    const auto* right = in_table<std::int64_t>(entry, "right");
    if (!right || *right < 1 || *right > std::ssize(question.choices))
        throw Error({file, entry.line}, "'right', the number of a choice from 1",
                    right ? std::to_string(*right) : "none");
    question.right = static_cast<std::size_t>(*right - 1);
}

template <class Each>
void for_each_in(const Value& root, const std::string& key, const Each& each) {
    if (const auto* list = in_table<Value::Array>(root, key))
        for (const auto& entry : *list) each(entry);
}

// The chapter's first exercise has the file: 07b asks what 07 does.
std::filesystem::path file_for(const Exercise& exercise) {
    for (const auto& other : exercises()) {
        const auto file = quiz_source / "exercises" / other.folder / "quiz.toml";
        if (other.chapter == exercise.chapter && std::filesystem::exists(file)) return file;
    }
    throw Error("chapter " + exercise.chapter + ": expected a quiz.toml in one of its exercises, found none");
}

}  // namespace

std::string plain_text(const std::string& markdown) {
    std::string text = markdown;
    const auto replace = [&](const char* pattern, const char* by) {
        text = std::regex_replace(text, std::regex(pattern), by);
    };
    replace(R"(\\(mathbf|mathsf|mathrm|text)\{([^}]*)\})", "$2");
    replace(R"(\\(tfrac|frac)\{([^}]*)\}\{([^}]*)\})", "$2/$3");
    replace(R"(\\sqrt\{([^}]*)\})", "sqrt($1)");
    replace(R"(\\cdot|\\times)", "·");
    replace(R"(\\approx)", "~");
    replace(R"(\\(le|leq)\b)", "<=");
    replace(R"(\\(ge|geq)\b)", ">=");
    replace(R"(\\(l|r)floor)", "");
    replace(R"(\\[,;! ])", " ");
    replace(R"(\\([A-Za-z]+))", "$1");
    replace(R"([*$`{}])", "");
    replace(R"(\[([^\]]*)\]\([^)]*\))", "$1");
    replace(R"(\s+)", " ");
    const auto begin = text.find_first_not_of(' ');
    return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

Quiz read_quiz(const Exercise& exercise) {
    const auto file = file_for(exercise).string();
    const auto root = toml_file::parse(read_file(file), file);
    Quiz quiz{.questions = questions_in(read_file(quiz_source / "chapters" / exercise.chapter / "README.md")),
              .predictions = {}};
    for_each_in(root, "question", [&](const Value& entry) {
        const auto begins = text_of(entry, "begins", file);
        const auto asked = std::ranges::find_if(
            quiz.questions, [&](const QuizQuestion& question) { return question.asks.starts_with(begins); });
        if (asked == quiz.questions.end())
            throw Error({file, entry.line}, "the beginning of a question of chapter " + exercise.chapter + "'s lesson",
                        "\"" + begins + "\"");
        add_answer(*asked, entry, file);
    });
    for_each_in(root, "predict", [&](const Value& entry) {
        quiz.predictions.push_back({text_of(entry, "case", file), text_of(entry, "method", file)});
    });
    return quiz;
}

bool is_answer(const QuizQuestion& question, const std::string& typed) {
    char* end = nullptr;
    const double number = std::strtod(typed.c_str(), &end);
    const bool is_number = end != typed.c_str();
    if (question.number)
        return is_number && std::abs(number - *question.number) <= close_enough * std::abs(*question.number);
    if (is_number) return number == static_cast<double>(question.right + 1);
    const auto& right = question.choices[question.right];
    return !typed.empty() && right.substr(0, right.find_first_of(" ,")) == typed.substr(0, typed.find_first_of(" ,"));
}

}  // namespace raylab::grading
