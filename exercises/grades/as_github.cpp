#include "formats.h"
#include "part_text.h"

#include "raylab/report/json_text.h"

#include <nlohmann/json.hpp>

// What classroom-resources/autograding-grading-reporter decodes from a step's output `result`. It sends the sum of the
// tests' scores; its printed table shows passed / total instead, which is the same where all parts have equal points.

namespace raylab::grading {

std::string as_github(const Grade& grade) {
    const bool internal = grade.outcome == Outcome::internal;
    nlohmann::ordered_json json{{"version", 1},
                                {"status", grade.passed() ? "pass"
                                           : internal     ? "error"
                                                          : "fail"},
                                {"max_score", points_number(grade.most)},
                                {"tests", nlohmann::ordered_json::array()}};
    const auto add = [&](const std::string& name, const std::string& status, double score, const std::string& message) {
        json["tests"].push_back({{"name", safe_text(name, longest_message)},
                                 {"status", status},
                                 {"score", score},
                                 {"message", safe_text(message, longest_message)},
                                 {"test_code", "raylab grade " + grade.exercise},
                                 {"filename", grade.submitted.file},
                                 {"line_no", 0},
                                 {"duration", static_cast<int>(1000 * grade.answer_seconds)}});
    };
    for (const auto& part : grade.parts)
        add(part.name, part.passed() ? "pass" : "fail", points_number(part.points), part_text_with_whole(grade, part));
    if (grade.parts.empty()) add(grade.exercise, internal ? "error" : "fail", 0, whole_text(grade));
    return json_text(json);
}

}  // namespace raylab::grading
