#pragma once

#include <glm/vec3.hpp>

// Linear RGB (Rec. 709 primaries) seen as the eye's opponents: lightness, red against green, blue against yellow.

namespace raylab {

/// Linear in light: Y 0 to 100 above a 16 below black, Cx, Cz; what FLIP blurs.
glm::dvec3 ycxcz_from_rgb(const glm::dvec3& rgb);
glm::dvec3 rgb_from_ycxcz(const glm::dvec3& ycxcz);

/// CIE L*a*b* (CIE 15): equal steps look about equal; L* from 0 to 100.
glm::dvec3 lab_from_rgb(const glm::dvec3& rgb);
glm::dvec3 rgb_from_lab(const glm::dvec3& lab);

}  // namespace raylab
