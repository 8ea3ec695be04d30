#include "class_table.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace raylab::grading {

namespace {

constexpr std::size_t bins = 11;  // tens of per cent, and all

std::string shared_by_those_like(const Grade& grade) {
    if (!grade.hint.empty()) return grade.hint;
    if (grade.outcome != Outcome::wrong && grade.outcome != Outcome::nonfinite) return grade.summary;
    std::string parts;
    for (const auto& part : grade.parts)
        if (!part.passed()) parts += (parts.empty() ? "wrong in: " : ", ") + part.name;
    return parts;
}

// What two submissions share that are wrong in the same way: a hint, or else their answers, or else what is said of
// them and the failing parts.
std::string likeness_of(const Grade& grade) {
    std::string key = to_string(grade.outcome) + "\n";
    if (!grade.hint_id.empty()) return key + "hint " + grade.hint_id;
    if (!grade.fingerprint.empty()) return key + "answers " + grade.fingerprint;
    for (const auto& part : grade.parts) key += part.passed() ? "1" : "0";
    return key + "\n" + shared_by_those_like(grade);
}

std::vector<AlikeGroup> alike_groups(const std::vector<const Grade*>& grades) {
    std::map<std::string, AlikeGroup> groups;
    for (const auto* grade : grades) {
        if (grade->passed() || grade->outcome == Outcome::internal) continue;
        auto& group = groups[likeness_of(*grade)];
        group.students.push_back(grade->student);
        if (group.students.size() > 1) continue;
        group.outcome = grade->outcome;
        group.hint_id = grade->hint_id;
        group.shared = shared_by_those_like(*grade);
    }
    std::vector<AlikeGroup> sorted;
    for (auto& [key, group] : groups) sorted.push_back(std::move(group));
    std::ranges::stable_sort(sorted, std::greater(), [](const auto& group) { return group.students.size(); });
    return sorted;
}

std::vector<PartFailures> part_failures(const std::vector<const Grade*>& grades) {
    std::vector<PartFailures> all;
    for (const auto* grade : grades)
        for (const auto& part : grade->parts) {
            auto found = std::ranges::find(all, part.name, &PartFailures::name);
            if (found == all.end()) found = all.insert(all.end(), {.name = part.name});
            ++found->asked;
            found->failed += !part.passed();
        }
    std::ranges::stable_sort(all, std::greater(), &PartFailures::failed);
    return all;
}

AssignmentSummary summary_of(const Assignment& assignment, const std::vector<const Grade*>& grades) {
    AssignmentSummary summary{.assignment = assignment,
                              .graded = grades.size(),
                              .distribution = std::vector<std::size_t>(bins),
                              .parts = part_failures(grades),
                              .alike = alike_groups(grades)};
    for (const auto* grade : grades) {
        summary.passed += grade->passed();
        if (grade->outcome == Outcome::internal) {
            ++summary.internal;
            continue;
        }
        summary.mean += grade->share();
        ++summary.distribution[static_cast<std::size_t>(std::floor(grade->share() * (bins - 1)))];
    }
    const auto judged = summary.graded - summary.internal;
    if (judged > 0) summary.mean *= 100.0 / static_cast<double>(judged);
    return summary;
}

Counted counted(const Grade* grade, const Assignment& assignment, const SubmissionList& list) {
    if (!grade) return {};
    Counted result{.grade = grade, .lost = list.has_lost(*grade)};
    result.late = assignment.deadline && grade->submitted.modified > to_string(*assignment.deadline);
    result.points = points_number(grade->points()) * (result.late ? assignment.late : 1);
    return result;
}

double total_of(const StudentRow& row, const std::vector<Assignment>& assignments) {
    const bool no_weights = std::ranges::all_of(assignments, [](const auto& one) { return one.weight == 0; });
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < assignments.size(); ++i) {
        const double weight = no_weights ? 1 : assignments[i].weight;
        weights += weight;
        const auto* grade = row.results[i].grade;
        if (grade && grade->most > 0) sum += weight * row.results[i].points / points_number(grade->most);
    }
    return weights > 0 ? 100 * sum / weights : 0;
}

std::vector<Assignment> asked_for(std::vector<Assignment> assignments, const std::vector<Grade>& grades) {
    std::erase_if(assignments, [&](const auto& assignment) {
        return std::ranges::find(grades, assignment.exercise->folder, &Grade::exercise) == grades.end();
    });
    for (const auto& grade : grades) {
        const auto known = std::ranges::any_of(
            assignments, [&](const auto& assignment) { return assignment.exercise->folder == grade.exercise; });
        if (!known) assignments.push_back({.exercise = &exercise(grade.exercise)});
    }
    return assignments;
}

}  // namespace

ClassTable class_table(const Course& course, const std::vector<Grade>& grades, const SubmissionList& list) {
    const auto assignments = asked_for(course.assignments, grades);
    std::map<std::string, std::map<std::string, const Grade*>> by_exercise;
    std::set<std::string> students;
    for (const auto& grade : grades) {
        by_exercise[grade.exercise][grade.student] = &grade;
        students.insert(grade.student);
    }
    ClassTable table{.title = course.title};
    for (const auto& assignment : assignments) {
        std::vector<const Grade*> of_it;
        for (const auto& [student, grade] : by_exercise[assignment.exercise->folder]) of_it.push_back(grade);
        table.assignments.push_back(summary_of(assignment, of_it));
    }
    for (const auto& student : students) {
        StudentRow row{.student = student};
        for (const auto& assignment : assignments) {
            const auto& of_it = by_exercise[assignment.exercise->folder];
            const auto found = of_it.find(student);
            row.results.push_back(counted(found == of_it.end() ? nullptr : found->second, assignment, list));
        }
        row.total = total_of(row, assignments);
        table.students.push_back(std::move(row));
    }
    return table;
}

}  // namespace raylab::grading
