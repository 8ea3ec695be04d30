#include "formats.h"
#include "part_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::grading {

std::string as_text(const Grade& grade) {
    std::size_t widest = 0;
    for (const auto& part : grade.parts) widest = std::max(widest, part.name.size());
    std::string text =
        fmt::format("Exercise {}: {}\n{}\n\n", grade.exercise, to_string(grade.outcome), whole_text(grade));
    for (const auto& part : grade.parts)
        text += fmt::format("  {}  {:<{}}  {:>6} of {:>6} points  {}\n", part.passed() ? "✓" : "✗", part.name, widest,
                            points_text(part.points), points_text(part.most), part.message);
    if (grade.outcome == Outcome::internal)
        text += "No points: the grader failed, and nothing is said about the submission.\n";
    else
        text += fmt::format("\n{} of {} points\n", points_text(grade.points()), points_text(grade.most));
    text += fmt::format("{}\n", conditions_text(grade));
    if (!grade.submitted.sha256.empty())
        text += fmt::format("{}, {} bytes, SHA-256 {}\n", grade.submitted.file, grade.submitted.bytes,
                            grade.submitted.sha256);
    constexpr std::size_t longest_text = 100'000;
    return safe_text(text, longest_text);
}

}  // namespace raylab::grading
