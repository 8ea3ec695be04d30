#include "raylab/radiosity/solve/gauss_seidel_sweep.h"
#include "raylab/base/unfinished.h"

// Exercise 14b. README.md beside this file says what to write; ./raylab check 14b says how it went.
void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) { throw Unfinished{}; }
