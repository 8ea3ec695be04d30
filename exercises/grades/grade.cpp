#include "grade.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::grading {

namespace {

// The points of a part as they are shown: rounded so that all of them together have the whole's sum.
Hundredths share(Hundredths most, std::size_t index, std::size_t count) {
    const auto up_to = [&](std::size_t parts) {
        return static_cast<Hundredths>(static_cast<std::size_t>(most) * parts / count);
    };
    return up_to(index + 1) - up_to(index);
}

}  // namespace

const std::string& to_string(Outcome outcome) {
    static const std::array<std::string, 15> words{
        "pass",   "wrong",        "nonfinite", "too_much_work",    "unfinished", "incomplete",    "crash",   "timeout",
        "memory", "output_limit", "policy",    "does_not_compile", "refused",    "no_submission", "internal"};
    return words[static_cast<std::size_t>(outcome)];
}

double GradePart::share() const {
    // Of few points for many parts some parts are worth less than a hundredth.
    if (most == 0) return passed() ? 1 : 0;
    return static_cast<double>(points) / most;
}

Hundredths Grade::points() const {
    if (parts.empty()) return 0;
    double shares = 0;
    for (const auto& part : parts) shares += part.share();
    const auto whole = std::lround(most * shares / static_cast<double>(parts.size()));
    return std::clamp(static_cast<Hundredths>(whole), 0, most);
}

double Grade::share() const { return most > 0 ? static_cast<double>(points()) / most : 0; }

bool Grade::was_asked() const {
    return outcome != Outcome::does_not_compile && outcome != Outcome::refused && outcome != Outcome::no_submission &&
           outcome != Outcome::internal;
}

std::vector<GradePart> with_equal_points(std::vector<GradePart> parts, Hundredths most) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].most = share(most, i, parts.size());
        parts[i].points = parts[i].passed() ? parts[i].most : 0;
    }
    return parts;
}

std::string points_text(Hundredths points) {
    if (points % 100 == 0) return std::to_string(points / 100);
    return fmt::format("{:.2f}", points_number(points));
}

}  // namespace raylab::grading
