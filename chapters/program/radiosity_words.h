#pragma once

#include "raylab/radiosity/hierarchical_scene.h"
#include "raylab/radiosity/scene_radiosity.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace raylab {

/// What `raylab radiosity` tells of a solved scene, as JSON and in some lines.
nlohmann::ordered_json radiosity_json(const SceneRadiosity& solved, const SceneRadiosityOptions& options);
std::string radiosity_words(const SceneRadiosity& solved);

/// What came from the cache, and what was wrong in it.
std::string cache_words(const SceneRadiosity& solved, const RadiosityCache& cache);

nlohmann::ordered_json radiosity_json(const SceneHierarchy& solved);
std::string radiosity_words(const SceneHierarchy& solved);

}  // namespace raylab
