#pragma once

#include "raylab/report/measure.h"
#include "raylab/report/structure/structure_method.h"
#include "raylab/report/structure/structure_workload.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// "What is the nearest hit?", asked of structures: speed against wrong answers.

namespace raylab {

/// What a structure says of rays. Asked for any hit, only whether there is one counts.
using StructureAnswers = std::vector<std::optional<Hit>>;

/// The answers of one structure to a workload; `traversal` counts what they cost.
StructureAnswers answers_of(const Accelerator& structure, const StructureWorkload& workload, Traversal& traversal);

/// How many answers are not what the list says: another primitive, other bits of t, a hit for a miss or a miss for a hit.
std::size_t wrong_answers(const StructureAnswers& answers, const StructureAnswers& truth, RayQuestion question);

/// What the exact list says of a workload.
StructureAnswers true_answers(const StructureWorkload& workload);

/// One structure on one workload: wrong answers in parts per million against nanoseconds a ray, with the build's time, and
/// per ray the counts "primitive tests", "box tests", "steps" and "exact decisions", and "bytes a primitive".
Measurement measure_structure(const StructureMethod& method, const StructureWorkload& workload,
                              const StructureAnswers& truth, const MeasureOptions& options = {});

/// All structures on all workloads.
Experiment measure_structures(const std::vector<StructureMethod>& methods, const std::vector<StructureWorkload>& workloads,
                              const MeasureOptions& options = {});

}  // namespace raylab
