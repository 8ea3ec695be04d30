#include "raylab/accelerator/bound_tree/bound_tree.h"

#include "raylab/accelerator/bound_tree/bound_tree_members.h"

namespace raylab {

template class BoundTree<BoxBounds>;
template class BoundTree<SphereBounds>;
template class BoundTree<SlabBounds>;

}  // namespace raylab
