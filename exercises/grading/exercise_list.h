#pragma once

#include "exercise.h"

// Each exercise, made by its own folder's judge.cpp.

namespace raylab::grading {

Exercise picture_ray_exercise();
Exercise ray_sphere_exercise();
Exercise ray_triangle_exercise();
Exercise transformed_normal_exercise();
Exercise phong_specular_exercise();
Exercise shadow_exercise();
Exercise refraction_exercise();
Exercise trace_exercise();
Exercise light_cell_exercise();
Exercise box_entry_exercise();
Exercise grid_step_exercise();
Exercise next_cell_exercise();
Exercise sah_cost_exercise();

}  // namespace raylab::grading
