#pragma once

#include "raylab/radiosity/visibility.h"

#include <cstdint>
#include <optional>
#include <string>

namespace raylab {

/// One side of the surfaces that an object's path in the scene names.
struct SurfaceName {
    std::string path;                    // "polygon 0", "pair[2]/sphere 0"
    std::optional<FacetSide> side = {};  // absent: the only side that is shown, or the front
};

/// Reads "sphere 0", "sphere 0:front" or "sphere 0:back".
SurfaceName surface_name(const std::string& words);

struct ObjectFormFactor {
    double value;
    double standard_error;  // of the visibility, and of a method that samples; 0 where nothing is hidden
    std::uint64_t rays;
    double surface_error;  // how far the flat pieces may lie from curved surfaces, metres
};

/// The form factor from one object to another, with what hides them from each other. Of each pair of their flat pieces
/// the factor in full view is computed by a method of form_factor_method_named(), with the most effort that its chart
/// shows; `polygon` has twelve digits. What is hidden of it is estimated by `samples` shadow rays in
/// all, each weighted with what it would carry: so where nothing is hidden nothing is estimated. Curved surfaces are
/// cut into pieces of at most `edge` metres. It throws an Error that lists the paths for one that the scene does not
/// have.
ObjectFormFactor object_form_factor(const Scene& scene, const SurfaceName& from, const SurfaceName& to, double edge,
                                    int samples, const std::string& method = "polygon");

/// The same from a small patch at a point, by Lambert's contour integral; the normal need not have length 1.
ObjectFormFactor point_form_factor(const Scene& scene, const Vec3d& point, const Vec3d& normal, const SurfaceName& to,
                                   double edge, int samples);

}  // namespace raylab
