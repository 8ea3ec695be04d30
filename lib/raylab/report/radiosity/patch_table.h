#pragma once

#include "raylab/report/radiosity/solved_scene.h"

#include <string>

namespace raylab {

/// One row for each patch: path,part,side,cx,cy,cz,nx,ny,nz,area,emission_r..b,reflectance_r..b,radiosity_r..b.
/// Emission is pi times the radiance; numbers are written so that reading them gives the same bits.
std::string patch_table(const SolvedScene& solved);

/// One row for each vertex: x,y,z,radiosity_r,radiosity_g,radiosity_b.
std::string vertex_table(const SolvedScene& solved);

}  // namespace raylab
