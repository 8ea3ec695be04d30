#include "formats.h"
#include "part_text.h"

#include "raylab/report/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

// https://gradescope-autograders.readthedocs.io/en/latest/specs/

namespace raylab::grading {

std::string as_gradescope(const Grade& grade) {
    nlohmann::ordered_json json{
        {"score", points_number(grade.points())},
        {"execution_time", grade.compile_seconds + grade.answer_seconds},
        {"output", safe_text(whole_text(grade) + "\n" + conditions_text(grade), longest_output)},
        {"output_format", "text"},
        {"test_output_format", "text"},
        {"test_name_format", "text"},
        {"stdout_visibility", "hidden"},
        {"extra_data", {{"verdict", to_string(grade.outcome)}, {"hint_id", grade.hint_id}, {"seed", nullptr}}},
        {"tests", nlohmann::ordered_json::array()}};
    if (grade.seed) json["extra_data"]["seed"] = *grade.seed;
    std::size_t number = 0;
    for (const auto& part : grade.parts)
        json["tests"].push_back({{"score", points_number(part.points)},
                                 {"max_score", points_number(part.most)},
                                 {"status", part.passed() ? "passed" : "failed"},
                                 {"name", safe_text(part.name, longest_message)},
                                 {"number", std::to_string(++number)},
                                 {"output", safe_text(part_text(grade, part), longest_output)}});
    return json_text(json);
}

}  // namespace raylab::grading
