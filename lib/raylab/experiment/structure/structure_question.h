#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/experiment/structure/structure_method.h"
#include "raylab/experiment/structure/structure_workload.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// The question "What is the nearest hit?" for structures: speed against wrong answers.

namespace raylab {

/// A structure's answers for rays. Where any hit is asked for, only its presence counts.
using StructureAnswers = std::vector<std::optional<Hit>>;

/// The answers of one structure to a workload; `traversal` counts their cost.
StructureAnswers answers_of(const Accelerator& structure, const StructureWorkload& workload, Traversal& traversal);

/// Whether two answers to a question are the same: hit or miss, and for the nearest hit its primitive and the bits of
/// t.
bool same_answer(const std::optional<Hit>& a, const std::optional<Hit>& b, RayQuestion question);

/// The number of answers that differ from the list's.
std::size_t wrong_answers(const StructureAnswers& answers, const StructureAnswers& truth, RayQuestion question);

/// The answers of the exact list to a workload.
StructureAnswers true_answers(const StructureWorkload& workload);

/// Measures one structure on one workload: wrong answers in parts per million against nanoseconds per ray, with the
/// build's time, and per ray the counts "primitive tests", "box tests", "steps" and "exact decisions", and "bytes a
/// primitive".
Measurement measure_structure(const StructureMethod& method, const StructureWorkload& workload,
                              const StructureAnswers& truth, const MeasureOptions& options = {});

/// Measures all structures on all workloads.
Experiment measure_structures(const std::vector<StructureMethod>& methods,
                              const std::vector<StructureWorkload>& workloads, const MeasureOptions& options = {});

}  // namespace raylab
