#pragma once

#include "raylab/experiment/adversarial/adversarial_scenes.h"

// Shapes of all kinds, for tests whose counts are published nowhere.

namespace raylab::adversarial {

inline Shape shape_of_every_kind(Draw& draw) { return draw.one_in(8) ? Shape(any_annulus(draw)) : any_shape(draw); }

inline Object object_of_every_kind(Draw& draw) {
    Object result = object(shape_of_every_kind(draw), any_placement(draw));
    result.sides = any_sides(draw);
    return result;
}

}  // namespace raylab::adversarial
