#include "submission_list.h"

#include "part_text.h"

#include "raylab/base/printable.h"

#include <sstream>

namespace raylab::grading {

SubmissionList::SubmissionList(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        lines_.insert(line);
        exercises_.insert(line.substr(0, line.find('/')));
    }
}

std::vector<std::string> SubmissionList::without_result(const std::vector<Grade>& grades) const {
    auto missing = lines_;
    for (const auto& grade : grades) missing.erase(line_of(grade.exercise, grade.student));
    return {missing.begin(), missing.end()};
}

bool SubmissionList::has_lost(const Grade& grade) const {
    return exercises_.contains(grade.exercise) && !lines_.contains(line_of(grade.exercise, grade.student));
}

std::string line_of(const std::string& exercise, const std::string& student) {
    // First as a result has the name.
    return exercise + "/" + printable(safe_text(student, longest_output));
}

std::string list_text(const std::vector<HandedIn>& submissions, const ClassTerms& terms) {
    std::string text;
    for (const auto& handed : submissions)
        text += line_of(handed.exercise, name_in_report(handed.student, terms)) + "\n";
    return text;
}

}  // namespace raylab::grading
