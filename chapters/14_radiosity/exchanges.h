#pragma once

#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/report/diagram/diagram.h"

namespace raylab::cornell {

/// The parts of the Cornell box, and the strongest exchanges between them: power that leaves one and arrives at the
/// other. The wider an arrow, the more.
Diagram exchange_diagram(const SceneRadiosity& solved);

}  // namespace raylab::cornell
