#pragma once

#include "raylab/scene/needs/facts.h"

#include <span>
#include <string>
#include <vector>

// The steps of needs_of(), in their order: each reads the results of those before it.

namespace raylab {

inline constexpr Color black{0, 0, 0};

/// The facts that are known at each step.
struct NeedsQuestion {
    const Scene& scene;
    const NeedsOptions& options;
    std::vector<ObjectFacts> objects;
    std::vector<std::vector<std::size_t>> walls;  // for each light, the walls around it
    bool bends_light;                             // some surface separates media of different indices of refraction

    bool worth_a_ray(double coefficient) const { return coefficient > 0 && coefficient > options.threshold; }
    const ObjectFacts* only_object() const { return objects.size() == 1 ? objects.data() : nullptr; }

    /// Whether rays that leave a surface show nothing but the background.
    bool shows_only_background() const { return only_object() && only_object()->clear; }
};

/// For each material of the scene, whether some ray can hit it.
std::vector<bool> seen_materials(const NeedsQuestion& question);

/// Computes NeedsQuestion::bends_light.
bool bends_light(const Scene& scene, const std::vector<ObjectFacts>& facts);

std::vector<LightNeeds> light_needs(const NeedsQuestion& question, const std::vector<bool>& seen);

/// The largest fractions that a surface of this material can reflect and transmit.
struct LargestShares {
    double reflected, transmitted;
};
LargestShares passed_on(const NeedsQuestion& question, const Material& material);

struct Recursion {
    RecursionNeeds passed_on;
    int depth;
};
Recursion recursion_needs(const NeedsQuestion& question, const std::vector<bool>& seen);

std::vector<MaterialNeeds> material_needs(const NeedsQuestion& question, const std::vector<bool>& seen,
                                          const std::vector<LightNeeds>& lights, const Recursion& recursion);

std::vector<LightPath> modelled_paths(const NeedsQuestion& question, const Needs& needs);
std::vector<LightPath> missed_paths(const NeedsQuestion& question, const Needs& needs);
std::vector<Note> asked_for(const NeedsQuestion& question, const Needs& needs);
std::vector<Note> left_out(const NeedsQuestion& question, const Needs& needs);
std::vector<Note> missed_effects(const NeedsQuestion& question, const Needs& needs);

std::vector<Note> warnings_of(const NeedsQuestion& question);

/// "light 2 (spot)", "material glass".
std::string light_name(const Scene& scene, std::size_t light);
std::string material_name(const Scene& scene, std::size_t material);

/// Why all rays may pass at one time.
std::string why_no_time(const Scene& scene);

/// "1 primitive", "12 primitives".
std::string primitives_of(const Needs& needs);

/// "a, b, c": the first few names, and how many more there are.
std::string list_of(std::span<const std::string> names);

/// The names of the materials for which `property` holds.
std::vector<std::string> materials_with(const Scene& scene, const std::vector<MaterialNeeds>& materials,
                                        bool MaterialNeeds::*property);

}  // namespace raylab
