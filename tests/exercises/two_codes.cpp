#include "catch.h"

#include "mistake_codes.h"
#include "rotating.h"
#include "sanitized.h"

#include <fmt/format.h>

#include <string>

// A hint that is found only for the code it was made with is worth little. So typical mistakes are recorded twice, in
// two codes that have nothing in common but the mistake. That they do have it in common, their numbers show.

using namespace raylab::grading;

namespace {

std::string names(const Codes& codes) {
    std::string names = fmt::format("  {}:", codes.front().hint);
    for (const auto& code : codes) names += " " + code.name;
    return names + "\n";
}

}  // namespace

TEST_CASE("fifteen typical mistakes and more are recorded in two codes each") {
    if (is_sanitized) return;  // known_answers.cpp runs the same judge and mistakes
    for (std::size_t i = 0; i < exercises().size(); ++i) {
        const auto& exercise = exercises()[i];
        if (!is_tested_now(i, 4)) continue;
        std::size_t twice = 0;
        std::string all;
        for (const auto& codes : mistakes_of(exercise)) {
            twice += codes.size() >= 2;
            all += names(codes);
        }
        INFO(exercise.folder << ": " << twice << " in two codes or more:\n" << all);
        CHECK(twice >= 15);
    }
}
