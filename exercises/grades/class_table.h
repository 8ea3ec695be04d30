#pragma once

#include "class_grading.h"
#include "submission_list.h"

#include <map>
#include <string>
#include <vector>

// What a course wants to know of its results: who has how many points, and what went wrong for many.

namespace raylab::grading {

/// One student's result for one assignment, as it counts.
struct Counted {
    const Grade* grade = nullptr;  // null: nothing was handed in, or not graded yet
    bool late = false;
    bool lost = false;  // its submission is no longer in the class
    double points = 0;  // after what lateness costs
};

struct StudentRow {
    std::string student;
    std::vector<Counted> results;  // one for each assignment
    double total = 0;              // per cent, by the weights
};

/// Submissions that are wrong in the same way.
struct AlikeGroup {
    Outcome outcome;
    std::string hint_id;  // empty: no hint fits
    std::vector<std::string> students;
    std::string shared;  // the hint or, without one, the parts that they fail, or why nothing could be judged
};

struct PartFailures {
    std::string name;
    std::size_t failed = 0, asked = 0;  // submissions
};

struct AssignmentSummary {
    Assignment assignment;
    std::size_t graded = 0, passed = 0, internal = 0;
    double mean = 0;                        // per cent of the points
    std::vector<std::size_t> distribution;  // submissions with 0 to 9, 10 to 19, ..., 90 to 99, and 100 per cent
    std::vector<PartFailures> parts;        // those that most fail first
    std::vector<AlikeGroup> alike;          // the largest first
};

struct ClassTable {
    std::string title;
    std::vector<AssignmentSummary> assignments;
    std::vector<StudentRow> students;  // by name
};

/// `grades` outlive the table; of those that `list` has lost it says so. The exercises are those with results: the
/// course's others were not asked for. Exercises that the course does not name count as those without weight and
/// deadline; if none has a weight, all count equally.
ClassTable class_table(const Course& course, const std::vector<Grade>& grades, const SubmissionList& list = {});

std::string class_csv(const ClassTable& table);
std::string class_json(const ClassTable& table);
std::string class_page(const ClassTable& table);
std::string student_page(const ClassTable& table, const StudentRow& row);

/// The student's page below the class's: numbered, since a name may hold what no address may.
std::string page_of(const ClassTable& table, const StudentRow& row);

}  // namespace raylab::grading
