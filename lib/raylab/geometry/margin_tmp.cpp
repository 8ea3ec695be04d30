#include "raylab/geometry/oracle.h"
double raylab::oracle::margin(const RayOf<double>&, const TriangleOf<double>&) { return 1; }
double raylab::oracle::margin(const RayOf<double>&, const SphereOf<double>&) { return 1; }
