#pragma once

#include "closed_mesh.h"
#include "judge.h"

#include "raylab/report/case_drawings.h"
#include "raylab/report/chapter.h"
#include "raylab/report/decision_trial.h"

#include <functional>
#include <string>
#include <vector>

// The parts from which the rows of the stability cases are made: a set of queries, and what is expected of one method's
// answers.

namespace raylab {

/// A workload of triangles with its exact answers.
class Trial : public DecisionTrial<Triangle, TriangleQuery, std::optional<TriangleHit>> {
public:
    Trial(const TriangleWorkload& workload, int threads)
        : DecisionTrial(workload, ray_triangle_methods(), truth_of(workload, threads)) {
        show_wrong_ones([](const TriangleWorkload& all, const TriangleQuery& query, TrueAnswer truth) {
            return example_of(query.ray, all.data[query.triangle], truth);
        });
    }
};

/// Rays from inside a closed mesh, and how many of them leak.
class LeakTrial {
public:
    explicit LeakTrial(Shots shots) : shots_(std::move(shots)) {}

    CaseRow leaks_more_than(double share, const std::string& title) const;
    CaseRow never_leaks(const std::string& title) const;
    CaseRow doubles_more_than(double share, const std::string& title) const;
    CaseRow always_one_hit(const std::string& title) const;

    const Shots& shots() const { return shots_; }
    /// A ray with the triangles that it is tested against.
    CaseExample example(std::size_t shot) const;

private:
    using Expects = std::function<bool(const Leaks&)>;
    // The row's example is the first ray that leaks, or that hits twice.
    CaseRow row(const std::string& title, const std::string& expected, const Expects& expects, Leak shown) const;

    Shots shots_;
};

/// "none leak, 37 % hit twice".
std::string in_words(const Leaks& leaks);

/// Adds a student's method to the rows, where there is one; nothing is expected of it.
void show_yours(const ChapterRun& run, const Trial& trial, std::vector<CaseRow>& rows);
void show_yours(const ChapterRun& run, const LeakTrial& trial, std::vector<CaseRow>& rows);

/// One of ray_triangle_methods() by its title.
TriangleMethod method_called(const std::string& title);

}  // namespace raylab
