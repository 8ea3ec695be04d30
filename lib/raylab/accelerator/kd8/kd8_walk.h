#pragma once

#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/accelerator/kd8/kd8_node.h"

namespace raylab {

/// Traversals of the cells along a ray, the nearest first, compiled for one instruction set.
struct Kd8Walks {
    /// False where floats do not suffice for the ray, as for bvh8's; then nothing has been tested.
    using Walk = bool (*)(const Kd8Cells&, const Bvh8Nodes& contents, const Bvh8Query&, Bvh8Leaves&, Traversal&);
    Walk nearest, any;
    Walk nearest_told;  // reports each node, by its index, and each leaf that it visits

    CompiledFaults (*faults)();  // of the code for this instruction set
};

/// The traversals for the best instruction set of this machine.
Kd8Walks best_kd8_walks();

}  // namespace raylab
