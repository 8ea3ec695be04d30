#include "raylab/accelerator/split_tree/cell_part.h"

#include "raylab/accelerator/split_tree/clipped_bounds.h"

namespace raylab {

CutPart cut_box(const Box& box, int axis, float at) {
    Box below = box, above = box;
    below.max[axis] = above.min[axis] = at;
    return {intersection(box, below), intersection(box, above)};
}

CutPart cut_part(const CellPart& part, const std::optional<Triangle>& triangle, int axis, float at) {
    const CutPart boxes = cut_box(part.box, axis, at);
    if (!triangle) return boxes;
    return {clipped_bounds(*triangle, boxes.below), clipped_bounds(*triangle, boxes.above)};
}

}  // namespace raylab
