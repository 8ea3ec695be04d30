#pragma once

#include "raylab/radiosity/scene_radiosity.h"

namespace raylab {

/// Solves a scene on equal patches, quarters those on which the light changes much, and solves again, until none does
/// (Cohen, Greenberg, Immel and Brock, An Efficient Radiosity Approach for Realistic Image Synthesis, IEEE Computer
/// Graphics and Applications 6(3), 1986). Form factors between patches that stay are kept. Much is more than
/// `difference` between two corners, as a share of the mean of what surfaces reflect. The edge that `options` ask for
/// is that of the smallest patches; the first have eight times that. Weak spot: what no patch of the first mesh
/// notices, such as a shadow in the middle of one, is never looked at.
SceneRadiosity adaptive_radiosity(const Scene& scene, const SceneRadiosityOptions& options, double difference);

}  // namespace raylab
