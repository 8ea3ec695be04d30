#pragma once

#include <chrono>
#include <string>

namespace raylab::grading {

using Moment = std::chrono::sys_seconds;  // UTC

Moment now();

/// "2026-11-30T23:59:00Z".
std::string to_string(Moment moment);

}  // namespace raylab::grading
