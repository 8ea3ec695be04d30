#pragma once

namespace raylab {

/// The weight of a sample that one strategy chose with density `pdf`, where another could have chosen it with density
/// `other`, both per steradian: pdf^2 / (pdf^2 + other^2). Each strategy weights its own samples; of one direction the
/// two weights sum to 1, so no light counts twice (Veach and Guibas, "Optimally Combining Sampling Techniques for Monte
/// Carlo Rendering", SIGGRAPH 1995). Densities are at least 0, and pdf is not 0; one of the two may be infinite. This
/// is the slot of exercise 15d.
double power_heuristic(double pdf, double other);

}  // namespace raylab
