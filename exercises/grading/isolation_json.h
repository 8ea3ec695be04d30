#pragma once

#include "level.h"

#include <nlohmann/json_fwd.hpp>

namespace raylab::grading {

/// {"level", "landlock", "seccomp", "own_user"}, as every verdict tells under what it came about.
nlohmann::ordered_json to_json(const Isolation& isolation);

}  // namespace raylab::grading
