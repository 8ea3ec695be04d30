#include "course.h"

#include "toml_table.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"

#include <ctime>

namespace raylab::grading {

namespace {

std::optional<Moment> moment_of(const std::string& text) {
    std::tm parts{};
    const char* end = strptime(text.c_str(), "%Y-%m-%d %H:%M", &parts);
    if (!end || *end) return std::nullopt;
    return Moment(std::chrono::seconds(timegm(&parts)));
}

Assignment assignment_of(const toml_file::Value& value, const std::string& file) {
    if (!std::holds_alternative<toml_file::Value::Table>(value.data))
        throw Error({file, value.line}, "exercises as tables ([[exercise]])", toml_file::in_words(value));
    const TomlTable table(value, file);
    table.knows_only({"number", "weight", "deadline", "late"});
    const auto number = table.find<std::string>("number", "a text such as \"02\"");
    if (!number) throw Error({file, value.line}, "a number in [[exercise]]", "none");
    Assignment assignment{.exercise = &exercise(*number)};
    constexpr double most_weight = 1e6;
    assignment.weight = table.number("weight", most_weight, "a number from 0 to 1e6").value_or(1);
    assignment.late = table.number("late", 1, "a share from 0 to 1").value_or(0);
    if (const auto text = table.find<std::string>("deadline", "a text such as \"2026-11-30 23:59\"")) {
        assignment.deadline = moment_of(*text);
        if (!assignment.deadline) table.fail(*table.entry("deadline"), "a moment such as \"2026-11-30 23:59\"");
    }
    return assignment;
}

}  // namespace

std::string to_string(Moment moment) {
    const std::time_t seconds = moment.time_since_epoch().count();
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

Course read_course(const std::filesystem::path& path) {
    const auto file = path.string();
    const auto root = toml_file::parse(read_file(path), file);
    const TomlTable table(root, file);
    table.knows_only({"title", "exercise"});
    Course course{.title = table.find<std::string>("title", "a text").value_or("")};
    const auto exercises = table.find<toml_file::Value::Array>("exercise", "tables ([[exercise]])");
    if (!exercises || exercises->empty()) throw Error({file}, "an [[exercise]]", "none");
    for (const auto& value : *exercises) course.assignments.push_back(assignment_of(value, file));
    return course;
}

}  // namespace raylab::grading
