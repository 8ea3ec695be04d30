#pragma once

#include "raylab/radiosity/hierarchy/hierarchical_radiosity.h"
#include "raylab/radiosity/system/power_balance.h"

namespace raylab {

/// Where the power of a solution goes; what the background sends in is emitted. Lost is what was sent
/// and arrived nowhere: not by the emitters' own form factors, which nobody gathers by and which are refined least. So
/// in a closed scene it is 0 but for the links' errors, and the imbalance is what the last iteration left.
PowerBalance hierarchical_power(const HierarchicalRadiosity& solved, int threads);

}  // namespace raylab
