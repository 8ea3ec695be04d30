#pragma once

#include "raylab/report/chapter.h"

namespace raylab::volumes {

/// Do spatial splits pay? Trees of boxes that may cut what they hold, beside those that may not: where triangles are evenly
/// small, where a few long ones run between them, where there is nothing but long ones, and in a full run on real meshes
/// where they have been fetched.
void tell_splits(const ChapterRun& run, Page& page);

}  // namespace raylab::volumes
