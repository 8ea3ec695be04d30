#pragma once

#include <glm/vec3.hpp>

// Conversions of linear RGB (Rec. 709 primaries) to opponent colours: lightness, red against green, blue against
// yellow.

namespace raylab {

/// Linear in light: Y from -16 for black to 100 for white, with Cx and Cz. FLIP blurs in this space.
glm::dvec3 ycxcz_from_rgb(const glm::dvec3& rgb);
glm::dvec3 rgb_from_ycxcz(const glm::dvec3& ycxcz);

/// CIE L*a*b* (CIE 15): equal steps look about equal; L* is from 0 to 100.
glm::dvec3 lab_from_rgb(const glm::dvec3& rgb);
glm::dvec3 rgb_from_lab(const glm::dvec3& lab);

}  // namespace raylab
