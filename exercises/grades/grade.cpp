#include "grade.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace raylab::grading {

const std::string& to_string(Outcome outcome) {
    static const std::array<std::string, 15> words{
        "pass",   "wrong",        "nonfinite", "too_much_work",    "unfinished", "incomplete",    "crash",   "timeout",
        "memory", "output_limit", "policy",    "does_not_compile", "refused",    "no_submission", "internal"};
    return words[static_cast<std::size_t>(outcome)];
}

Hundredths Grade::points() const {
    Hundredths sum = 0;
    for (const auto& part : parts) sum += part.points;
    return std::clamp(sum, 0, most);
}

std::string points_text(Hundredths points) {
    if (points % 100 == 0) return std::to_string(points / 100);
    return fmt::format("{:.2f}", points_number(points));
}

}  // namespace raylab::grading
