#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/radiosity/radiosity_system.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <filesystem>
#include <string>

namespace raylab {

/// The memory that the form factors of so many patches take.
MemoryNeed form_factors_need(std::size_t patches);

/// Reads a system given as numbers, as JSON:
/// {"area": [A ...], "emission": [E ...], "reflectance": [rho ...], "F": [[F_00, F_01 ...] ...]}:
/// area is in square metres, emission and reflectance hold a number or [r, g, b] for each patch, and F a row for each.
/// It throws an Error, with `source` and the place in it, for sizes that do not fit each other, for numbers that no
/// system has (an area not above 0, a negative emission or form factor, a reflectance outside [0, 1), anything that is
/// not finite), for other fields, and for more memory than the limit. Row sums are judged by solve().
RadiositySystem system_from_json(const nlohmann::ordered_json& json, const std::string& source,
                                 const MemoryLimit& limit = {});

/// Reads the same from a file.
RadiositySystem read_system(const std::filesystem::path& path, const MemoryLimit& limit = {});

}  // namespace raylab
