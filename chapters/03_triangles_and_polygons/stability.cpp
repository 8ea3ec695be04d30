#include "stability.h"

namespace raylab {

std::vector<StabilityCase> stability_cases(const ChapterRun& run) {
    return {edge_shot(run), vertex_shot(run), fma_switch(run), det_eps(run),      sliver(run),
            far_scene(run), range(run),       lattice(run),    double_input(run), epick_ray(run)};
}

}  // namespace raylab
