#include "class_table.h"
#include "part_text.h"

#include "raylab/report/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab::grading {

namespace {

using Json = nlohmann::ordered_json;

// RFC 4180. What begins like a formula is not to be one in a spreadsheet.
std::string csv_field(const std::string& text) {
    std::string safe = safe_text(text, longest_message);
    if (!safe.empty() && std::string_view("=+-@").find(safe[0]) != std::string_view::npos) safe.insert(0, "'");
    if (safe.find_first_of(",\"\n") == std::string::npos) return safe;
    for (auto at = safe.find('"'); at != std::string::npos; at = safe.find('"', at + 2)) safe.insert(at, "\"");
    return "\"" + safe + "\"";
}

Json to_json(const AssignmentSummary& summary) {
    const auto& assignment = summary.assignment;
    Json json{{"exercise", assignment.exercise->folder},
              {"weight", assignment.weight},
              {"deadline", nullptr},
              {"late", assignment.late},
              {"graded", summary.graded},
              {"passed", summary.passed},
              {"internal", summary.internal},
              {"mean_per_cent", summary.mean},
              {"distribution", summary.distribution},
              {"parts", Json::array()},
              {"alike", Json::array()}};
    if (assignment.deadline) json["deadline"] = to_string(*assignment.deadline);
    for (const auto& part : summary.parts)
        json["parts"].push_back({{"name", part.name}, {"failed", part.failed}, {"asked", part.asked}});
    for (const auto& group : summary.alike)
        json["alike"].push_back({{"verdict", to_string(group.outcome)},
                                 {"hint_id", group.hint_id},
                                 {"shared", group.shared},
                                 {"students", group.students}});
    return json;
}

Json to_json(const ClassTable& table, const StudentRow& row) {
    Json json{{"student", row.student}, {"total_per_cent", row.total}, {"results", Json::object()}};
    for (std::size_t i = 0; i < row.results.size(); ++i) {
        const auto& result = row.results[i];
        if (!result.grade) continue;
        json["results"][table.assignments[i].assignment.exercise->folder] = {
            {"verdict", to_string(result.grade->outcome)},
            {"score", points_number(result.grade->points())},
            {"max_score", points_number(result.grade->most)},
            {"counted", result.points},
            {"late", result.late},
            {"hint_id", result.grade->hint_id},
            {"seed", result.grade->seed ? Json(*result.grade->seed) : Json(nullptr)}};
    }
    return json;
}

}  // namespace

std::string class_csv(const ClassTable& table) {
    std::string csv = "student,total";
    for (const auto& summary : table.assignments) {
        const auto name = csv_field(summary.assignment.exercise->folder);
        csv += fmt::format(",{0} points,{0} verdict,{0} late,{0} hint", name);
    }
    csv += "\r\n";
    for (const auto& row : table.students) {
        csv += fmt::format("{},{:.2f}", csv_field(row.student), row.total);
        for (const auto& [grade, late, points] : row.results)
            csv += grade ? fmt::format(",{:.2f},{},{},{}", points, to_string(grade->outcome), late ? "late" : "",
                                       csv_field(grade->hint_id))
                         : ",,,,";
        csv += "\r\n";
    }
    return csv;
}

std::string class_json(const ClassTable& table) {
    Json json{{"format", "raylab.class/1"},
              {"title", table.title},
              {"assignments", Json::array()},
              {"students", Json::array()}};
    for (const auto& summary : table.assignments) json["assignments"].push_back(to_json(summary));
    for (const auto& row : table.students) json["students"].push_back(to_json(table, row));
    return json_text(json);
}

}  // namespace raylab::grading
