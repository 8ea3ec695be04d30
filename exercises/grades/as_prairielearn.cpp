#include "formats.h"
#include "part_text.h"

#include "raylab/report/json_text.h"

#include <nlohmann/json.hpp>

// https://prairielearn.readthedocs.io/en/latest/externalGrading/: a submission that cannot be graded costs no attempt.

namespace raylab::grading {

std::string as_prairielearn(const Grade& grade) {
    const bool gradable = grade.was_asked();
    nlohmann::ordered_json json{
        {"gradable", gradable},
        {"score", gradable ? grade.share() : 0.0},
        {"message", safe_text(grade.summary, longest_message)},
        {"output", safe_text(whole_text(grade) + "\n" + conditions_text(grade), longest_output)},
        {"tests", nlohmann::ordered_json::array()}};
    if (!gradable) json["format_errors"] = {safe_text(whole_text(grade), longest_message)};
    for (const auto& part : grade.parts)
        json["tests"].push_back({{"name", safe_text(part.name, longest_message)},
                                 {"points", points_number(part.points)},
                                 {"max_points", points_number(part.most)},
                                 {"message", safe_text(part_text(grade, part), longest_message)}});
    return json_text(json);
}

}  // namespace raylab::grading
