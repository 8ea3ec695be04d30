#include "raylab/scene/nff/spd_sides.h"

namespace raylab {

Scene with_spd_sides(Scene scene) {
    for (Object& object : scene.objects) {
        const bool round_about_an_axis =
            std::holds_alternative<Cone>(object.shape) || std::holds_alternative<Cylinder>(object.shape);
        if (!round_about_an_axis) object.sides = Sides::both;
    }
    return scene;
}

}  // namespace raylab
