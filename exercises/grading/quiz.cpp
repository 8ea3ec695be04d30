#include "quiz.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/report/provenance.h"
#include "raylab/scene/toml/toml_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

namespace raylab::grading {

namespace {

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

void add_answer(QuizQuestion& question, const TomlTable& table) {
    const auto sealed = [&](const char* key) {
        const auto* hash = table.find<std::string>(key, "a text");
        if (hash) question.seal = QuizSeal{table.text("begins"), *hash};
        return hash != nullptr;
    };
    sealed("sealed_number");
    question.number = table.number("number", "a number");
    question.choices = table.texts("choices");
    if (question.choices.empty() || sealed("sealed_right")) return;
    const std::string expected = "the number of a choice from 1";
    const auto right = table.number("right", static_cast<double>(question.choices.size()), expected);
    if (!right || *right < 1 || *right != std::floor(*right)) table.fail("right", expected);
    question.right = static_cast<std::size_t>(*right) - 1;
}

// The chapter's first exercise has the file: 07b asks what 07 does.
std::filesystem::path file_for(const Exercise& exercise) {
    for (const auto& other : exercises()) {
        const auto file = source_folder() / "exercises" / other.folder / "quiz.toml";
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
    return quiz_in(read_file(file), file, read_file(source_folder() / "chapters" / exercise.chapter / "README.md"));
}

Quiz quiz_in(const std::string& answers, const std::string& file, const std::string& lesson) {
    const auto root = toml_file::parse(answers, file);
    Quiz quiz{.questions = questions_in(lesson), .predictions = {}, .orders = {}};
    const TomlTable table(root, file);
    for (const auto& entry : table.tables("question")) {
        const auto& begins = entry.text("begins");
        const auto asked = std::ranges::find_if(
            quiz.questions, [&](const QuizQuestion& question) { return question.asks.starts_with(begins); });
        if (asked == quiz.questions.end()) entry.fail("begins", "the beginning of a question of the chapter's lesson");
        add_answer(*asked, entry);
    }
    for (const auto& entry : table.tables("predict"))
        quiz.predictions.push_back({entry.text("case"), entry.text("method")});
    for (const auto& entry : table.tables("order")) {
        const auto* knob = entry.find<std::string>("knob", "a text");
        quiz.orders.push_back({entry.text("chart"), entry.text("workload"), knob ? *knob : "", entry.texts("methods")});
        if (quiz.orders.back().methods.size() < 2) entry.fail("methods", "two methods or more");
    }
    return quiz;
}

bool is_answer(const QuizQuestion& question, const std::string& typed) {
    char* end = nullptr;
    const double number = std::strtod(typed.c_str(), &end);
    const bool is_number = end != typed.c_str();
    if (question.number)
        return is_number && std::abs(number - *question.number) <= close_enough * std::abs(*question.number);
    if (question.seal && question.choices.empty()) return is_number && seals_number(*question.seal, number);
    const auto first_word = [](const std::string& text) { return text.substr(0, text.find_first_of(" ,")); };
    for (std::size_t i = 0; i < question.choices.size(); ++i) {
        const bool is_typed = is_number ? number == static_cast<double>(i + 1)
                                        : !typed.empty() && first_word(question.choices[i]) == first_word(typed);
        if (is_typed && (question.seal ? seals_choice(*question.seal, i) : i == question.right)) return true;
    }
    return false;
}

bool is_order(const std::vector<double>& errors, const std::string& typed) {
    std::string spaced = typed;
    std::ranges::replace(spaced, ',', ' ');
    std::istringstream numbers(spaced);
    std::vector<double> ordered;
    std::set<std::size_t> named;
    for (std::size_t number = 0; numbers >> number;) {
        if (number < 1 || number > errors.size() || !named.insert(number).second) return false;
        ordered.push_back(errors[number - 1]);
    }
    return numbers.eof() && ordered.size() == errors.size() && std::ranges::is_sorted(ordered);
}

}  // namespace raylab::grading
