#include "raylab/scene/scene_bounds.h"

namespace raylab {

Box scene_bounds(const Scene& scene) {
    Box box;
    for (const Object& object : scene.objects)
        if (const auto of_shape = bounds(object.shape, object.placement)) box = unite(box, *of_shape);
    return box;
}

}  // namespace raylab
