#pragma once

#include "raylab/experiment/structure/structure_question.h"
#include "raylab/report/stability.h"

#include <functional>
#include <string>

namespace raylab {

/// A workload with the exact list's answers, from which the rows of a structure's stability case are made.
class StructureTrial {
public:
    explicit StructureTrial(StructureWorkload workload);

    // Each of these makes a row that expects something of a method's answers.
    CaseRow more_wrong_than(double share, const StructureMethod& method) const;
    CaseRow never_wrong(const StructureMethod& method) const;

    /// A row for a method of which nothing is expected: a student's.
    CaseRow shown(const StructureMethod& method) const;

    const StructureWorkload& workload() const { return workload_; }

private:
    // The row's example is the first ray that is answered wrongly.
    CaseRow row(const StructureMethod& method, const std::string& expected,
                const std::function<bool(double wrong)>& expects) const;

    StructureWorkload workload_;
    StructureAnswers truth_;
};

}  // namespace raylab
