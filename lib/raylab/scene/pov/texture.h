#pragma once

#include "raylab/scene/scene.h"

#include <string>

namespace raylab::pov {

/// The declarations of a material: Material_3, or Material_3_a and Material_3_b for the cells of a checker.
std::string declared_material(const Material& material, std::size_t index);

/// The texture of a declared material on an object, after its placement: patterns are laid on in the scene.
std::string texture_on(const Object& object, const Material& material, std::size_t index);

/// Whether POV-Ray can lay a checker on a shape as we do, along the normal's dominant axis.
bool says_checker_on(const Shape& shape);

}  // namespace raylab::pov
