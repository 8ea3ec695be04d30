#pragma once

#include "class_grading.h"

#include <set>
#include <string>
#include <vector>

// REPORT/submissions.txt: what the class handed in, EXERCISE/STUDENT a line, so that a report tells what it lacks and
// what it has too much.

namespace raylab::grading {

constexpr const char* list_of_submissions = "submissions.txt";

class SubmissionList {
public:
    SubmissionList() = default;
    explicit SubmissionList(const std::string& text);

    /// What is listed and has no result, as lines.
    std::vector<std::string> without_result(const std::vector<Grade>& grades) const;

    /// Whether the result's exercise is listed, but not for its student: the submission was taken back.
    bool has_lost(const Grade& grade) const;

private:
    std::set<std::string> lines_, exercises_;
};

/// The list's line for a submission. A name of several lines is one line there.
std::string line_of(const std::string& exercise, const std::string& student);

/// The list's text.
std::string list_text(const std::vector<HandedIn>& submissions, const ClassTerms& terms);

}  // namespace raylab::grading
