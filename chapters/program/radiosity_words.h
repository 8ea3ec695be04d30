#pragma once

#include "raylab/radiosity/radiosity_within.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace raylab {

/// What `raylab radiosity` tells of a solved scene, as JSON and in some lines.
nlohmann::ordered_json radiosity_json(const SceneRadiosity& solved, const SceneRadiosityOptions& options);
std::string radiosity_words(const SceneRadiosity& solved);

/// What came from the cache, and what was wrong in it; nothing is said of none.
std::string cache_words(const SceneRadiosity& solved, const RadiosityCache* cache);

nlohmann::ordered_json with_error(nlohmann::ordered_json json, const PictureError& error);
std::string error_words(const PictureError& error);

/// What was tried to come within an error.
nlohmann::ordered_json attempts_json(const RadiosityWithin& within);
std::string attempts_words(const RadiosityWithin& within);

nlohmann::ordered_json radiosity_json(const SceneHierarchy& solved, const RadiosityCache* cache);
std::string radiosity_words(const SceneHierarchy& solved);
std::string cache_words(const SceneHierarchy& solved, const RadiosityCache* cache);

}  // namespace raylab
