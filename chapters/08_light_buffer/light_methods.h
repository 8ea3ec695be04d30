#pragma once

#include "raylab/accelerator/light_buffer/light_buffered.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chart/chart.h"
#include "raylab/report/structure/structure_question.h"

#include <memory>
#include <string>
#include <vector>

// The chapter's question as data: a feeler in, stopped or not out, by every way of finding out.

namespace raylab::lantern {

/// A way to answer feelers, and what its knob is set to.
struct LightMethod {
    StructureMethod method;
    std::string knob = {};
};

/// A light buffer of so many cells along the cube's edge, called "conservative" (or "yours", with a student's cell),
/// "rectangles" or "centres". Rays that it knows nothing about go through a list.
StructureMethod light_buffer(Listing listing, int resolution, const ChapterRun& run);

/// Feelers through a list and through a tree, and light buffers of every kind and several resolutions.
std::vector<LightMethod> light_methods(const ChapterRun& run);

/// A lamp among so many triangles of about that size, and feelers from all about.
StructureWorkload among_triangles(const std::string& name, std::size_t triangles, double size, std::size_t rays,
                                  std::uint64_t seed);

/// A feeler as the tracer casts it, from a point in empty space.
Ray feeler_from(const Vec3d& point, const Vec3d& light);

/// The lantern, lamps among small and large triangles, a mesh under a lamp.
std::vector<StructureWorkload> light_workloads(const ChapterRun& run);

/// Can shadows be cheaper? Wrong answers against time.
Experiment measure_light_buffers(const ChapterRun& run);

/// What a light buffer takes as its cells grow smaller: counts, the same on every machine.
std::vector<std::string> resolution_header();
std::vector<std::vector<std::string>> resolution_rows(const ChapterRun& run);

/// The time to make a buffer, over the resolution: for few primitives and for many.
CurveChart build_chart(const ChapterRun& run);

/// Tests a feeler over the resolution: a lamp near the things, and the same lamp from farther and farther away.
CurveChart distance_chart(const ChapterRun& run);

}  // namespace raylab::lantern
