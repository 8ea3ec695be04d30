#pragma once

#include "catch.h"

#include "raylab/base/process.h"

#include <algorithm>
#include <string>

/// A program of the lab could not do what was asked: its exit code says so, and one line with these words.
inline void check_could_not(const raylab::ProcessResult& result, const std::string& words) {
    INFO(to_string(result) << "\n" << result.errors);
    CHECK(result.end == raylab::ProcessResult::End::exited);
    CHECK(result.code == 2);
    CHECK(result.errors.starts_with("raylab: "));
    CHECK(std::ranges::count(result.errors, '\n') == 1);
    CHECK_THAT(result.errors, Catch::Contains(words));
}
