#include "quiz_seal.h"

#include "sha256.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace raylab::grading {

namespace {

constexpr double step = 0.01;   // of numbers, relative: those within one step have one hash
constexpr int near_enough = 2;  // steps

std::string hash_of(const std::string& question, const std::string& answer) {
    return hexadecimal(hmac_sha256(question, answer));
}

int steps_to(double number) { return static_cast<int>(std::lround(std::log(std::abs(number)) / step)); }

std::string hash_of_steps(const std::string& question, double number, int steps) {
    return hash_of(question, fmt::format("{}{}", number < 0 ? "minus " : "", steps));
}

std::string hash_of_choice(const std::string& question, std::size_t choice) {
    return hash_of(question, fmt::format("choice {}", choice));
}

}  // namespace

bool seals_number(const QuizSeal& seal, double number) {
    if (!std::isfinite(number) || number == 0) return false;
    for (int off = -near_enough; off <= near_enough; ++off)
        if (seal.hash == hash_of_steps(seal.question, number, steps_to(number) + off)) return true;
    return false;
}

bool seals_choice(const QuizSeal& seal, std::size_t choice) {
    return seal.hash == hash_of_choice(seal.question, choice);
}

std::string sealed_quiz(const std::string& answers) {
    std::istringstream lines(answers);
    std::string sealed, question;
    bool is_prediction = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("[[")) is_prediction = line == "[[predict]]" || line == "[[order]]";
        if (is_prediction) continue;
        const auto value_of = [&](const std::string& key) {
            return line.starts_with(key + " = ") ? line.substr(key.size() + 3) : std::string();
        };
        if (const auto begins = value_of("begins"); !begins.empty()) question = begins.substr(1, begins.size() - 2);
        if (const auto value = value_of("number"); !value.empty()) {
            const double number = std::strtod(value.c_str(), nullptr);
            line = fmt::format("sealed_number = \"{}\"", hash_of_steps(question, number, steps_to(number)));
        }
        if (const auto value = value_of("right"); !value.empty())
            line = fmt::format("sealed_right = \"{}\"",
                               hash_of_choice(question, std::strtoul(value.c_str(), nullptr, 10) - 1));
        sealed += line + "\n";
    }
    return sealed;
}

std::string without_answers(const std::string& lesson) {
    const std::string begin = "<details><summary>Answer</summary>", end = "</details>";
    std::string text;
    std::size_t place = 0;
    for (std::size_t found; (found = lesson.find(begin, place)) != lesson.npos;) {
        text += lesson.substr(place, found - place) + begin + " The quiz of the exercise judges yours. " + end;
        const auto after = lesson.find(end, found);
        if (after == lesson.npos) return text;
        place = after + end.size();
    }
    return text + lesson.substr(place);
}

}  // namespace raylab::grading
