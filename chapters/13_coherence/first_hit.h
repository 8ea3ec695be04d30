#pragma once

#include "raylab/experiment/structure/structure_workload.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/camera.h"

#include <functional>
#include <string>
#include <vector>

namespace raylab::coherence {

/// A camera's rays through the centers of pixels, in tiles of 8 x 8 pixels: each tile is a packet.
StructureWorkload tiled_camera_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, int side);

/// The bumpy sphere of this chapter.
std::shared_ptr<const Scene> ball(int levels);

/// The same through a telescope, from ten thousand radii away, where floats resolve less of it.
std::shared_ptr<const Scene> far_ball(int levels);

/// A method that finds first hits. It is given all of a workload's rays at once, so that neighbouring rays may share
/// work.
struct Method {
    std::string name, number;
    using Answers = std::vector<std::optional<Hit>>;
    using Answer = std::function<Answers(Traversal&)>;
    std::function<Answer(const StructureWorkload&)> prepare;
    enum class Of { camera_rays, all_rays } of = Of::all_rays;
};
std::vector<Method> methods();

/// "What does each of these rays hit first?": all methods on coherent rays, on less coherent ones, and on incoherent
/// ones.
Experiment measure_first_hit(const ChapterRun& run);

}  // namespace raylab::coherence
