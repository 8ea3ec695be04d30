#include "raylab/accelerator/light_buffer/light_cell.h"
#include "raylab/base/unfinished.h"

// Exercise 08. README.md beside this file says what to write; ./raylab check 08 says how it went.
raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) { throw Unfinished{}; }
