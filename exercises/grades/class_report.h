#pragma once

#include "course.h"
#include "grade.h"
#include "submission_list.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raylab::grading {

/// What a class's report is made of, or the reports of its parts together.
struct ClassReport {
    struct File {
        std::filesystem::path report;  // that it was read from
        std::string text;
    };
    std::map<std::filesystem::path, File> files;  // by their place in a report
    std::vector<Grade> grades;                    // in the order of their files
    Course course;
    SubmissionList list;
};

/// Reads reports as one. An Error names the file that is no result, or that is another in an earlier report.
ClassReport read_reports(const std::vector<std::filesystem::path>& reports);

}  // namespace raylab::grading
