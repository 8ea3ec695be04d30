#include "raylab/accelerator/light_buffer/light_through_list.h"

#include "raylab/base/unfinished.h"

// Exercise 08b. README.md beside this file says what to write; ./raylab check 08b says how it went.
double raylab::light_through_list(const AskedLightList& list) { throw Unfinished{}; }
