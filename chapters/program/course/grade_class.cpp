#include "course/grade.h"

#include "class_report.h"
#include "class_table.h"
#include "seeds.h"
#include "spreadsheet.h"

#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/outputs.h"
#include "raylab/base/print.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <set>

namespace raylab {

namespace fs = std::filesystem;
using namespace grading;

namespace {

fs::path report_folder(const Arguments& arguments) {
    const fs::path folder = arguments.text("--output");
    if (folder == "-") throw Error("expected -o REPORT, the folder of the class's report, found none");
    return folder;
}

// What the folder's course.toml says, of all its exercises or of the one that is asked for.
Course course_in(const fs::path& folder, const Arguments& arguments) {
    const auto file = folder / "course.toml";
    Course course = fs::exists(file) ? read_course(file) : Course{};
    if (!arguments.has("NN")) {
        if (course.assignments.empty()) throw Error({folder.string()}, "an exercise (NN), or a course.toml", "neither");
        return course;
    }
    const auto& asked = exercise(arguments.text("NN"));
    std::erase_if(course.assignments, [&](const auto& assignment) { return assignment.exercise != &asked; });
    if (course.assignments.empty()) course.assignments.push_back({.exercise = &asked});
    return course;
}

ClassTerms terms_of(const Arguments& arguments) {
    ClassTerms terms{.report = report_folder(arguments), .most = points_asked_for(arguments)};
    if (const auto level = arguments.text_if_given("--isolation")) terms.words = {"--isolation", *level};
    if (const auto key = arguments.text_if_given("--key")) terms.key = read_course_key(*key);
    terms.seed = seed_if_given(arguments);
    terms.pseudonyms = arguments.has("--pseudonyms");
    if (terms.pseudonyms && !terms.key)
        throw Error("expected --key with --pseudonyms, since anyone could tell names made without one; found none");
    terms.regrade = arguments.has("--regrade");
    constexpr long long most_jobs = 64;
    if (arguments.has("--jobs")) terms.threads = static_cast<int>(arguments.integer("--jobs", 1, most_jobs));
    return terms;
}

std::vector<HandedIn> part_of(const std::vector<HandedIn>& all, const Arguments& arguments) {
    if (!arguments.has("--part")) return all;
    const auto part = two_integers(arguments.text("--part"), '/');
    if (!part || (*part)[0] < 1 || (*part)[0] > (*part)[1])
        throw Error("expected --part I/N with I from 1 to N, found " + arguments.text("--part"));
    const auto first = static_cast<std::size_t>((*part)[0] - 1), step = static_cast<std::size_t>((*part)[1]);
    std::vector<HandedIn> mine;
    for (std::size_t i = first; i < all.size(); i += step) mine.push_back(all[i]);
    return mine;
}

// Who is who, beside the report and for the course alone: nobody else may enter the folder in which the file waits for
// its mode and its place.
void write_names(const std::vector<HandedIn>& all, const ClassTerms& terms) {
    constexpr auto owner_only = fs::perms::owner_read | fs::perms::owner_write;
    std::set<std::string> records;
    for (const auto& handed : all)
        records.insert(spreadsheet_record({name_in_report(handed.student, terms), handed.student}));
    std::string text = spreadsheet_record({"pseudonym", "student"});
    for (const auto& record : records) text += record;
    const fs::path file = fs::path(terms.report.string() + ".names.csv");
    if (fs::exists(file)) fs::permissions(file, owner_only);  // the new file takes the old one's mode
    Outputs outputs({.folders = {file.parent_path()}});
    outputs.naming_folders([&] {
        const auto staged = outputs.staged(file.parent_path()).path / file.filename();
        write_file(staged, text);
        fs::permissions(staged, owner_only);
    });
    outputs.commit();
}

void write_pages(const fs::path& folder, const ClassReport& report) {
    const auto table = class_table(report.course, report.grades, report.list);
    write_file(folder / "grades.csv", class_csv(table));
    write_file(folder / "grades.json", class_json(table));
    write_file(folder / "index.html", class_page(table));
    for (const auto& row : table.students) write_file(folder / page_of(table, row), student_page(table, row));
}

// Tables and pages, put in place together with the files that lie in other reports.
void write_report(const fs::path& folder, const ClassReport& report) {
    Outputs outputs({.folders = {folder}});
    outputs.naming_folders([&] {
        const auto staged = outputs.staged(folder).path;
        for (const auto& [place, file] : report.files)
            if (file.report != folder) write_file(staged / place, file.text);
        write_pages(staged, report);
    });
    outputs.commit();
}

std::string words_of(const ClassRun& run) {
    std::string text = fmt::format("{} submission{} graded", run.graded, run.graded == 1 ? "" : "s");
    if (run.kept) text += fmt::format(", {} unchanged since they were", run.kept);
    if (run.other_cases)
        text += fmt::format("\n{} of these were asked cases that have changed since: --regrade asks them again",
                            run.other_cases);
    if (run.internal) text += fmt::format("\n{} could not be graded: the same command tries them again", run.internal);
    for (const auto& change : run.changes) text += "\n" + change;
    return text + "\n";
}

// What to do about it depends on why, so results are kept.
std::string words_of_lost(const ClassReport& report) {
    std::string text;
    for (const auto& grade : report.grades)
        if (report.list.has_lost(grade))
            text += "no longer in the class, but in its report: " + line_of(grade.exercise, grade.student) + "\n";
    return text;
}

// The report first, if there is one already: its own files stay as they are.
std::vector<fs::path> reports_for(const fs::path& report, const std::vector<std::string>& parts) {
    std::vector<fs::path> reports;
    if (fs::is_directory(report / "results")) reports.push_back(report);
    for (const fs::path part : parts)
        if (!fs::exists(report) || !fs::equivalent(part, report)) reports.push_back(part);
    return reports;
}

}  // namespace

ExitCode grade_class(const Arguments& arguments) {
    const fs::path folder = arguments.text("--class");
    const auto course = course_in(folder, arguments);
    const auto terms = terms_of(arguments);
    // Among the submissions the next run would take the report for a student's.
    const Outputs planned({.folders = {terms.report}, .inputs = {folder}});
    const auto all = handed_in(folder, course);
    write_file(terms.report / list_of_submissions, list_text(all, terms));
    if (fs::exists(folder / "course.toml")) write_file(terms.report / "course.toml", read_file(folder / "course.toml"));
    if (terms.pseudonyms) write_names(all, terms);
    const auto run = grade_class(part_of(all, arguments), terms);
    auto text = words_of(run);
    if (arguments.has("--part")) {
        text += "then, when all parts are done: raylab grade --merge " + terms.report.string() + "\n";
    } else {
        const auto report = read_reports({terms.report});
        write_report(terms.report, report);
        text += words_of_lost(report);
        text += "the report: " + (terms.report / "index.html").string() + "\n";
    }
    print_text(text);
    return run.internal ? ExitCode::negative : ExitCode::as_it_should_be;
}

ExitCode merge_reports(const Arguments& arguments) {
    const auto& parts = arguments.all("NN");
    if (parts.empty()) throw Error("expected reports to be merged, found none");
    const auto given = arguments.text("--output");
    if (given == "-" && parts.size() > 1) throw Error("expected -o REPORT for several parts, found none");
    const fs::path report = given == "-" ? parts.front() : given;
    const auto merged = read_reports(reports_for(report, parts));
    const auto missing = merged.list.without_result(merged.grades);
    write_report(report, merged);
    std::string text = "the report: " + (report / "index.html").string() + "\n";
    for (const auto& name : missing) text += "not graded yet: " + name + "\n";
    print_text(text);
    return missing.empty() ? ExitCode::as_it_should_be : ExitCode::negative;
}

}  // namespace raylab
