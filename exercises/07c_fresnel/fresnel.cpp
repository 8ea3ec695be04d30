#include "raylab/tracer/shading/fresnel.h"

#include "raylab/base/unfinished.h"

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    throw Unfinished{};  // TODO: the share that is reflected
}
