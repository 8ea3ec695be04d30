#pragma once

#include "raylab/scene/scene.h"

#include <string>

namespace raylab::pov {

/// The declarations of a material: Material_3, or Material_3_a and Material_3_b for the cells of a checker.
std::string declared_material(const Material& material, std::size_t index);

/// The texture of a declared material on an object. It stands after the object's placement, because patterns are in the
/// scene's coordinates.
std::string texture_on(const Object& object, const Material& material, std::size_t index);

/// Whether POV-Ray can project a checker onto the shape as the lab does, along the normal's dominant axis.
bool says_checker_on(const Shape& shape);

}  // namespace raylab::pov
