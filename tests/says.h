#pragma once

#include "raylab/base/process.h"

#include <string>

/// Whether a program's standard output holds these words.
inline bool says(const raylab::ProcessResult& result, const std::string& words) {
    return result.output.find(words) != std::string::npos;
}
