#pragma once

#include "raylab/scene/scene.h"

#include <string>
#include <string_view>

namespace raylab {

/// A scene in Haines' Neutral File Format (version 3.1, in the Standard Procedural Databases). What the format leaves
/// open is decided here:
/// - Only words matter, not lines; the view may stand anywhere, once. `hither` is checked but not used, because rays
///   start at the eye. `angle` lies between the top and the bottom edge of the picture and pixels are square: with rays
///   through pixel corners this gives the ray counts published for the databases; the format's text (from pixel centre
///   to pixel centre) does not.
/// - A light without a colour is white; n lights have intensity 1 / sqrt(n) each, so that many of them do not
///   overexpose the picture.
/// - f r g b Kd Ks Shine T ior: diffuse Kd (r, g, b), highlights Ks in white, kr = Ks and kt = T, which are both
///   divided by Ks + T where that exceeds 1; ior 0 stands for 1 on an opaque surface.
/// - Opaque objects are seen from their front only (from inside where radii are negative), transmitting ones from both
///   sides. Cones and cylinders are open.
/// - A polygon's front is that of its Newell normal. A patch is a Mesh with its normals, split into a fan from its
///   first vertex; one that cannot be fanned (concave as seen from there) is kept as a Polygon, without them.
Scene read_nff(std::string_view text, const std::string& file);

}  // namespace raylab
