#pragma once

#include "raylab/scene/needs/parts.h"

#include <string>
#include <vector>

// What a scene needs whose rays are spread: by distributed ray tracing, or by paths.

namespace raylab {

/// The names of lights, and of materials that are seen and have something.
struct SpreadFacts {
    RenderModel model;  // distributed or path
    std::vector<std::string> points = {}, area_lights = {};
    std::vector<std::string> diffuse = {}, checkers = {};
    std::vector<std::string> spreading = {};  // by gloss or roughness
    std::vector<std::string> mirrors = {}, glass = {}, sharp_mirrors = {}, sharp_glass = {};
    std::vector<std::string> choosing = {};  // between lobes
    std::vector<std::string> ambient = {}, highlights = {}, emission = {};

    /// Whether light falls on a surface that spreads it.
    bool is_lit() const {
        return !(points.empty() && area_lights.empty()) &&
               !(diffuse.empty() && spreading.empty() && (model == RenderModel::path || highlights.empty()));
    }
};
SpreadFacts spread_facts(const NeedsQuestion& question, RenderModel model);

/// What the random numbers of a sample are for, and what light no strategy of the model finds.
std::vector<Note> sample_dimensions(const NeedsQuestion& question, const Needs& needs, const SpreadFacts& facts);
std::vector<Note> unreached_light(const SpreadFacts& facts);

/// The light paths that the model follows, what it models, and what it does without in the same picture.
std::vector<LightPath> spread_paths(const Scene& scene, const SpreadFacts& facts);
std::vector<Note> asked_of_spread(const Scene& scene, const Needs& needs, const SpreadFacts& facts);
std::vector<Note> left_out_of_spread(const Scene& scene, const Needs& needs, const SpreadFacts& facts);

}  // namespace raylab
