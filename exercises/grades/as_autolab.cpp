#include "formats.h"
#include "part_text.h"

#include "raylab/report/json_text.h"

#include <nlohmann/json.hpp>

// https://docs.autolabproject.com/lab/ and /features/formatted-feedback/: the last line of standard output is the
// result, and its problem has to exist in the assessment: it is named as the exercise is. Where the grader itself
// failed there is no score, so that the old one stays.

namespace raylab::grading {

namespace {

// One line, since Autolab takes the last one alone.
std::string line_of(const nlohmann::ordered_json& json) {
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string as_autolab(const Grade& grade) {
    nlohmann::ordered_json shown{{"_presentation", "semantic"},
                                 {"stages", {"Build", "Test"}},
                                 {"Build", {{"compile", {{"passed", grade.was_asked()}}}}},
                                 {"Test", nlohmann::ordered_json::object()}};
    if (!grade.was_asked()) shown["Build"]["compile"]["hint"] = safe_text(whole_text(grade), longest_message);
    for (const auto& part : grade.parts) {
        nlohmann::ordered_json test{{"passed", part.passed()}};
        if (!part.passed()) test["hint"] = safe_text(part_text_with_whole(grade, part), longest_message);
        shown["Test"][safe_text(part.name, longest_message)] = std::move(test);
    }
    nlohmann::ordered_json scores = nlohmann::ordered_json::object();
    if (grade.outcome != Outcome::internal) scores[grade.exercise] = points_number(grade.points());
    return line_of(shown) + line_of({{"scores", scores}});
}

}  // namespace raylab::grading
