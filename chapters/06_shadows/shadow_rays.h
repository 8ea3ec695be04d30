#pragma once

#include "raylab/experiment/shadow_oracle.h"
#include "raylab/report/chapter.h"
#include "raylab/tracer/shading/ray_start.h"

#include <span>
#include <string>
#include <vector>

// The chapter's question as data: for a point and a light, whether it is lit or in shadow, by every way of starting the
// shadow ray.

namespace raylab::shadows {

using ShadowMethod = Method<Scene, ShadowQuestion, Shade>;
using ShadowWorkload = Workload<Scene, ShadowQuestion>;  // the data is one scene

/// A way of starting shadow rays, with its title in charts.
struct NamedStart {
    std::string name;
    RayStart start;
};
std::vector<NamedStart> starts();

/// The lab's tracer with each of these starts, and exercise 06's function over a list in doubles.
std::vector<ShadowMethod> shadow_methods(const ChapterRun& run);

/// The position and size of a scene, which an offset has to suit.
struct Situation {
    std::string name, about;
    double scale, away, eye;  // in metres; the eye's distance is in scales
};
std::vector<Situation> situations();

/// Points whose answer is the same for every point and light within ShadowOracle::band_ulps: no edge of a shadow is
/// near.
struct JudgedWorkload {
    ShadowWorkload workload;
    std::vector<Shade> truth;
};
JudgedWorkload shadow_workload(const Situation& situation, std::size_t questions, const ChapterRun& run);

/// The shadow ray that a start makes from the question's point.
Ray shadow_ray_from(const Scene& scene, const RayStart& start, const ShadowQuestion& question);

/// How often a method is wrong, and in which way, in parts per million of all questions.
struct WrongShadows {
    double acne = 0, lost_contact = 0;
    double all() const { return acne + lost_contact; }
};
WrongShadows wrong_shadows(std::span<const Shade> answers, std::span<const Shade> truth);
WrongShadows wrong_shadows(const ShadowMethod& method, const JudgedWorkload& judged);

/// Is a point lit? Measures wrong answers against time.
Experiment measure_shadow_rays(const ChapterRun& run);

}  // namespace raylab::shadows
