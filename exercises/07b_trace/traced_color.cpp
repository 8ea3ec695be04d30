#include "raylab/tracer/traced_color.h"
#include "raylab/base/unfinished.h"

// Exercise 07b. README.md beside this file says what to write; ./raylab check 07b says how it went.
raylab::Vec3d raylab::traced_color(const TracedLevel& level) { throw Unfinished{}; }
