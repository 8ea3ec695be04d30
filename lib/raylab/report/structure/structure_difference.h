#pragma once

#include "raylab/report/structure/structure_method.h"
#include "raylab/scene/scene.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Where a structure does not say what brute force says: how that is found out, and the smallest case of it.

namespace raylab {

/// Rays asked one after another, by one caller. Mostly one will do; a structure that remembers (mailboxes, blockers) may
/// need some before it.
struct StructureCase {
    Scene scene;
    std::vector<Ray> rays;
};

/// Two answers to the last ray of a case.
struct Disagreement {
    std::string expected, found;
};

/// Says what is wrong with a case; absent: nothing.
using CaseJudge = std::function<std::optional<Disagreement>(const StructureCase&)>;

/// Asks a structure and the exact list: the same primitive, the same bits of t, u and v, and occluded() where there is a hit,
/// for the last ray of a case; and closest_of() all its rays.
CaseJudge judge_by_list(const StructureMethod& structure);

/// Asks the list and the oracle: the same primitive, t within one float.
std::optional<Disagreement> judge_by_oracle(const StructureCase& asked);

/// A disagreement with few rays and few primitives: none of them can be left out.
StructureCase minimised(StructureCase failing, const CaseJudge& judge);

/// A caller that asks one structure ray after ray, as a picture does.
class StructureCaller {
public:
    explicit StructureCaller(const Accelerator& structure) : structure_(structure) { feeling_.toward(0); }

    /// What is not as expected.
    std::optional<Disagreement> ask(const Ray& ray, const std::optional<Hit>& expected);

private:
    const Accelerator& structure_;
    Traversal seeing_, feeling_;
};

/// A ray that closest_of() answers otherwise than expected.
struct TogetherDisagreement {
    std::size_t ray;
    Disagreement answers;
};
std::optional<TogetherDisagreement> disagreement_together(const Accelerator& structure, std::span<const Ray> rays,
                                                          std::span<const std::optional<Hit>> expected);

/// "nothing", "part 7 of object 0 at t = 0.5 (0x1p-1)".
std::string words(const std::optional<Hit>& hit);

}  // namespace raylab
