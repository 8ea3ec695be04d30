#include "raylab/radiosity/solve/second_matrix.h"

#include "raylab/radiosity/system/read_system.h"

namespace raylab {

MemoryNeed second_matrix_need(const RadiositySystem& system) {
    MemoryNeed need = form_factors_need(system.patches());
    need.what = "a second matrix, which sweeps and shots do without,";
    return need;
}

void check_second_matrix(const RadiositySystem& system, const SolverOptions& options) {
    check_memory(second_matrix_need(system), options.limit, {"the radiosity system"});
}

}  // namespace raylab
