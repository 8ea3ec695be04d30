#include "course.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/scene/toml/toml_table.h"

#include <algorithm>
#include <ctime>

namespace raylab::grading {

namespace {

std::optional<Moment> moment_of(const std::string& text) {
    std::tm parts{};
    const char* end = strptime(text.c_str(), "%Y-%m-%d %H:%M", &parts);
    if (!end || *end) return std::nullopt;
    // strptime takes 30 February, too.
    const std::chrono::year_month_day date{std::chrono::year(1900 + parts.tm_year),
                                           std::chrono::month(static_cast<unsigned>(1 + parts.tm_mon)),
                                           std::chrono::day(static_cast<unsigned>(parts.tm_mday))};
    if (!date.ok()) return std::nullopt;
    return std::chrono::sys_days(date) + std::chrono::hours(parts.tm_hour) + std::chrono::minutes(parts.tm_min);
}

const Exercise& exercise_of(const TomlTable& table) {
    const auto& name = table.text("number");
    try {
        return exercise(name);
    } catch (const Error& unknown) {
        throw Error(to_string(table.place("number")) + ": " + unknown.what());
    }
}

Assignment assignment_of(const TomlTable& table) {
    table.knows_only({"number", "weight", "deadline", "late"});
    Assignment assignment{.exercise = &exercise_of(table)};
    constexpr double most_weight = 1e6;
    assignment.weight = table.number("weight", most_weight, "a number from 0 to 1e6").value_or(1);
    assignment.late = table.number("late", 1, "a share from 0 to 1").value_or(0);
    const std::string moment = "a moment such as \"2026-11-30 23:59\"";
    if (const auto* text = table.find<std::string>("deadline", moment)) {
        assignment.deadline = moment_of(*text);
        if (!assignment.deadline) table.fail("deadline", moment);
    }
    return assignment;
}

}  // namespace

Course read_course(const std::filesystem::path& path) {
    const auto file = path.string();
    const auto root = toml_file::parse(read_file(path), file);
    const TomlTable table(root, file);
    table.knows_only({"title", "exercise"});
    Course course;
    if (const auto* title = table.find<std::string>("title", "a text")) course.title = *title;
    for (const auto& exercise : table.tables("exercise")) {
        const auto assignment = assignment_of(exercise);
        // Both would have the same results.
        if (std::ranges::find(course.assignments, assignment.exercise, &Assignment::exercise) !=
            course.assignments.end())
            exercise.fail("number", "an exercise of its own");
        course.assignments.push_back(assignment);
    }
    if (course.assignments.empty()) throw Error({file}, "an [[exercise]]", "none");
    if (std::ranges::all_of(course.assignments, [](const auto& assignment) { return assignment.weight == 0; }))
        throw Error({file}, "a weight above 0", "none, so that there would be no total");
    return course;
}

}  // namespace raylab::grading
