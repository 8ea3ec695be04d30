#include "class_report.h"

#include "grade_json.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/read_json.h"

#include <nlohmann/json.hpp>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> result_files(const fs::path& report) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(report / "results"))
        if (entry.is_regular_file() && entry.path().extension() == result_extension) files.push_back(entry.path());
    return files;
}

}  // namespace

ClassReport read_reports(const std::vector<fs::path>& reports) {
    ClassReport all;
    std::map<fs::path, Grade> grades;
    for (const auto& report : reports) {
        if (!fs::is_directory(report / "results")) throw Error({report.string()}, "a report with results", "none");
        for (const auto& file : result_files(report)) {
            const auto place = file.lexically_relative(report);
            const auto text = read_file(file);
            grades.try_emplace(place, grade_from_json(json_from_text(text, file.string()), file.string()));
            const auto& first = all.files.try_emplace(place, ClassReport::File{report, text}).first->second;
            if (text != first.text)
                throw Error({file.string()}, "the same result as in " + (first.report / place).string(), "another");
        }
        if (const auto file = report / "course.toml"; fs::exists(file)) {
            all.course = read_course(file);
            all.files.insert_or_assign("course.toml", ClassReport::File{report, read_file(file)});
        }
        if (const auto file = report / list_of_submissions; fs::exists(file)) {
            const auto text = read_file(file);
            all.list = SubmissionList(text);
            all.files.insert_or_assign(list_of_submissions, ClassReport::File{report, text});
        }
    }
    for (auto& [place, grade] : grades) all.grades.push_back(std::move(grade));
    return all;
}

}  // namespace raylab::grading
