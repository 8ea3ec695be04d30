#include "class_table.h"
#include "part_text.h"
#include "spreadsheet.h"

#include "raylab/report/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab::grading {

namespace {

using Json = nlohmann::ordered_json;

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
            {"lost", result.lost},
            {"hint_id", result.grade->hint_id},
            {"seed", result.grade->seed ? Json(*result.grade->seed) : Json(nullptr)}};
    }
    return json;
}

std::vector<std::string> cells_of(const Counted& result) {
    if (!result.grade) return std::vector<std::string>(4);
    return {fmt::format("{:.2f}", result.points), to_string(result.grade->outcome), result.late ? "late" : "",
            result.grade->hint_id};
}

}  // namespace

std::string class_csv(const ClassTable& table) {
    std::vector<std::string> header{"student", "total"};
    for (const auto& summary : table.assignments)
        for (const auto* column : {" points", " verdict", " late", " hint"})
            header.push_back(summary.assignment.exercise->folder + column);
    std::string csv = spreadsheet_record(header);
    for (const auto& row : table.students) {
        std::vector<std::string> cells{row.student, fmt::format("{:.2f}", row.total)};
        for (const auto& result : row.results)
            for (auto& cell : cells_of(result)) cells.push_back(std::move(cell));
        csv += spreadsheet_record(std::move(cells));
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
