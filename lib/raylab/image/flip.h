#pragma once

#include "raylab/image/image.h"

#include <vector>

// How different two pictures look to someone who flips between them.
// P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astroem, M. D. Fairchild: FLIP: A Difference Evaluator
// for Alternating Images. Proc. ACM Comput. Graph. Interact. Tech. 3(2), article 15 (High-Performance Graphics 2020).
//
// Both pictures go through the same steps (the numbers are ours, the constants the paper's), r in degrees of view:
//   (1) blur each opponent channel (Y, Cx, Cz) as the eye does: a1 sqrt(pi/b1) exp(-pi^2 r^2/b1) + a2 sqrt(pi/b2) ...,
//       scaled to a sum of one; then clamp to what the screen can show
//   (2) to L*a*b*, and Hunt's effect: (L, a, b) -> (L, 0.01 L a, 0.01 L b), chroma fades in the dark
//   (3) HyAB distance of two colours: |dL| + sqrt(da^2 + db^2)
//   (4) color: the distance to the power 0.7; what is under 0.4 of the largest (green against blue) takes the range
//       [0, 0.95], the rest what remains
//   (5) edges, points: the length of the first, the second derivatives of a Gaussian 0.082 degrees wide, applied to Y
//   in
//       [0, 1]; positive and negative weights each sum to one
//   (6) feature: sqrt(max(|difference of edges|, |difference of points|) / sqrt 2)
//   (7) FLIP = color^(1 - feature): a colour difference weighs more where an edge or a point came or went

namespace raylab {

/// One number for each pixel, row by row from the top.
struct ErrorMap {
    int width, height;
    std::vector<double> values;

    double mean() const;  // 0 for an empty map
    double at(int x, int y) const {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// The paper's assumption: a monitor 0.7 m and 3840 pixels wide, seen from 0.7 m.
inline constexpr double usual_pixels_per_degree = 67.0206;

/// The perceived difference of every pixel, from 0 (none) to 1 (green against blue), between pictures of the same size
/// with finite values; values outside [0, 1] are clamped, as a screen does. It is symmetric in its two pictures.
ErrorMap flip(const Image& reference, const Image& test, double pixels_per_degree = usual_pixels_per_degree);

}  // namespace raylab
