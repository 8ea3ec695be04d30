#include "raylab/accelerator/bvh/bvh.h"

#include "raylab/accelerator/bvh/bvh_members.h"

namespace raylab {

template class Bvh<BoxBounds>;
template class Bvh<SphereBounds>;
template class Bvh<SlabBounds>;
template class Bvh<MovingBoxBounds>;

}  // namespace raylab
