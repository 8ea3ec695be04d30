#pragma once

#include <fmt/format.h>

#include <string>

// What many scenes of tests are written of.

namespace raylab::test {

inline std::string image_text(int width, int height) {
    return fmt::format("[image]\nwidth = {}\nheight = {}\n", width, height);
}

/// What every channel of a material reflects and emits.
inline std::string material_text(const std::string& name, double diffuse, double emission = 0) {
    return fmt::format("[material.{0}]\ndiffuse = [{1}, {1}, {1}]\nemission = [{2}, {2}, {2}]\n", name, diffuse,
                       emission);
}

/// `vertices` as in a file: "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]".
inline std::string polygon_text(const std::string& vertices, const std::string& material,
                                const std::string& more = {}) {
    return fmt::format("[[shape]]\ntype = \"polygon\"\nvertices = {}\nmaterial = \"{}\"\n{}", vertices, material, more);
}

/// All pixels look straight down at the origin from half a metre above it.
inline std::string downward_camera_text() {
    return "[camera]\nposition = [0, 0, 0.5]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nfov_y = 1e-6\n";
}

/// A white plane through the origin, which looks up the z axis.
inline std::string floor_text() {
    return material_text("floor", 1) + "[[shape]]\ntype = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\nmaterial = "
                                       "\"floor\"\n";
}

/// A floor two metres below a square light of radiance 1 and a square metre.
inline std::string floor_below_light_text() {
    return downward_camera_text() + floor_text() + material_text("light", 0, 1) +
           polygon_text("[[-0.5, -0.5, 2], [0.5, -0.5, 2], [0.5, 0.5, 2], [-0.5, 0.5, 2]]", "light");
}

/// The radiance of that floor at the origin: its form factor to the light.
inline constexpr double floor_below_light = .073477634812521;

}  // namespace raylab::test
