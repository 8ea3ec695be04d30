#pragma once

#include "raylab/accelerator/light_buffer/light_buffer.h"
#include "raylab/accelerator/light_buffer/light_pyramid.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// The one cell that the lesson follows: of a coarse cube, from the foot of the wall past the red ball and the cage.

namespace raylab::lantern {

/// Cells along an edge of the coarse cube.
inline constexpr int coarse = 8;

/// The point on the wall whose shadow ray is asked.
inline const Vec3d shown_point{-2, 0.25, -1.22};

Vec3d light_of(const Scene& scene);
LightBuffer buffer_of(const Scene& scene, int resolution);
LightCell shown_cell(const Scene& scene);

/// The pyramid from the light through that cell.
LightPyramid shown_pyramid(const Scene& scene);

/// A primitive of the scene in plain words, by its object: "ball", "bar of the cage".
std::string plain_name(const Scene& scene, const LightBuffer& buffer, std::uint32_t place);

/// The list of that cell: the table's header, and a row for each primitive, the nearest first.
std::vector<std::string> cell_header();
std::vector<std::vector<std::string>> cell_rows(const Scene& scene);

}  // namespace raylab::lantern
