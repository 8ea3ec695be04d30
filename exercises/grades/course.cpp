#include "course.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/scene/toml/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <string_view>

namespace raylab::grading {

namespace {

using toml_file::Entry;
using toml_file::Value;

// One table of the file, whose keys are asked for one after the other.
class CourseTable {
public:
    CourseTable(const Value& value, const std::string& file)
        : table_(std::get<Value::Table>(value.data)), file_(file) {}

    template <class T>
    std::optional<T> find(const std::string& name, const std::string& expected) const {
        const auto* entry = toml_file::find(table_, name);
        if (!entry) return std::nullopt;
        if (const auto* value = std::get_if<T>(&entry->value.data)) return *value;
        fail(*entry, expected);
    }

    // A number that is not negative, written with or without a point.
    std::optional<double> number(const std::string& name, double most, const std::string& expected) const {
        const auto* entry = toml_file::find(table_, name);
        if (!entry) return std::nullopt;
        const auto* whole = std::get_if<std::int64_t>(&entry->value.data);
        const auto* real = std::get_if<double>(&entry->value.data);
        const double value = whole ? static_cast<double>(*whole) : real ? *real : -1;
        if (!(value >= 0 && value <= most)) fail(*entry, expected);
        return value;
    }

    void knows_only(std::initializer_list<std::string_view> names) const {
        for (const auto& entry : table_)
            if (std::ranges::find(names, entry.name) == names.end())
                throw Error({file_, entry.line}, fmt::format("one of the keys {}", fmt::join(names, ", ")), entry.name);
    }

    [[noreturn]] void fail(const Entry& entry, const std::string& expected) const {
        throw Error({file_, entry.line}, entry.name + " to be " + expected, toml_file::in_words(entry.value));
    }

    const Entry* entry(const std::string& name) const { return toml_file::find(table_, name); }

private:
    const Value::Table& table_;
    std::string file_;
};

std::optional<Moment> moment_of(const std::string& text) {
    std::tm parts{};
    const char* end = strptime(text.c_str(), "%Y-%m-%d %H:%M", &parts);
    if (!end || *end) return std::nullopt;
    return Moment(std::chrono::seconds(timegm(&parts)));
}

Assignment assignment_of(const Value& value, const std::string& file) {
    if (!std::holds_alternative<Value::Table>(value.data))
        throw Error({file, value.line}, "exercises as tables ([[exercise]])", toml_file::in_words(value));
    const CourseTable table(value, file);
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
    const CourseTable table(root, file);
    table.knows_only({"title", "exercise"});
    Course course{.title = table.find<std::string>("title", "a text").value_or("")};
    const auto exercises = table.find<Value::Array>("exercise", "tables ([[exercise]])");
    if (!exercises || exercises->empty()) throw Error({file}, "an [[exercise]]", "none");
    for (const auto& value : *exercises) course.assignments.push_back(assignment_of(value, file));
    return course;
}

}  // namespace raylab::grading
