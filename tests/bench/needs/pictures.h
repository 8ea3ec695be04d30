#pragma once

#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

/// The scene as `raylab render` draws it, on one thread: everything that the renderer can do, less what the scene does
/// not need.
raylab::Image by_renderer(const raylab::Scene& scene, const raylab::CameraFrame& frame);

/// The same bits for any one shape: through the accelerator and surface_point(), but no more light than one lamp's
/// Phong.
raylab::Image by_seam(const raylab::Scene& scene, const raylab::CameraFrame& frame);

/// The same bits by a program that can do nothing else: eye rays, one sphere, Phong, one point light.
raylab::Image by_hand(const raylab::Scene& scene, const raylab::CameraFrame& frame);
