#pragma once

#include "raylab/report/chapter.h"

namespace raylab::volumes {

/// Do spatial splits pay? Compares trees of boxes that may split their primitives with those that may not: where
/// triangles are equally small, where a few long ones are between them, where there are only long ones, and in a full
/// run on scanned meshes where they have been fetched.
void tell_splits(const ChapterRun& run, Page& page);

}  // namespace raylab::volumes
