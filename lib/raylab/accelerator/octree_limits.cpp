#include "raylab/accelerator/octree.h"

namespace raylab {

OctreeLimits PointSearch::limits(std::size_t) { return {}; }
OctreeLimits HashTable::limits(std::size_t) { return {}; }
OctreeLimits Seads::limits(std::size_t) { return {.seads = {.most = 64, .bits = 2}}; }

}  // namespace raylab
