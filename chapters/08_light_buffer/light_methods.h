#pragma once

#include "raylab/accelerator/light_buffer/light_buffered.h"
#include "raylab/experiment/structure/structure_question.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chart/chart.h"

#include <memory>
#include <string>
#include <vector>

// The chapter's question as data: for a shadow ray, whether it is occluded, by every method.

namespace raylab::lantern {

/// A method for shadow rays, and its setting.
struct LightMethod {
    StructureMethod method;
    std::string knob = {};
};

/// A light buffer with this many cells along the cube's edge, called "conservative" (or "yours", with a student's
/// light_cell()), "rectangles" or "centres". Rays that it does not cover are passed to a list.
StructureMethod light_buffer(Listing listing, int resolution, const ChapterRun& run);

/// The light buffer as it was published, in doubles (experiment/textbook/textbook_light_buffer.h), called "textbook"
/// (or "yours", with a student's light_through_list() or listed_cells()).
StructureMethod textbook_light_buffer(int resolution, const ChapterRun& run);

/// Shadow rays through a list and through a tree, light buffers of every kind and several resolutions, and the
/// textbook's.
std::vector<LightMethod> light_methods(const ChapterRun& run);

/// A light among this many triangles of about that size, with shadow rays from all around.
StructureWorkload among_triangles(const std::string& name, std::size_t triangles, double size, std::size_t rays,
                                  std::uint64_t seed);

/// A shadow ray as the tracer casts it, from a point in empty space.
Ray shadow_ray_from(const Vec3d& point, const Vec3d& light);

/// The lantern, lights among small and large triangles, a mesh under a light.
std::vector<StructureWorkload> light_workloads(const ChapterRun& run);

/// Can shadows be cheaper? Measures wrong answers against time.
Experiment measure_light_buffers(const ChapterRun& run);

/// The counts of a light buffer as its cells become smaller; they are the same on every machine.
std::vector<std::string> resolution_header();
std::vector<std::vector<std::string>> resolution_rows(const ChapterRun& run);

/// Tests for each shadow ray over the resolution: with a light near the objects, and with the same light farther and
/// farther away.
CurveChart distance_chart(const ChapterRun& run);

}  // namespace raylab::lantern
