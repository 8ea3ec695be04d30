#pragma once

#include "raylab/experiment/structure/structure_method.h"
#include "raylab/scene/scene.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Finds rays for which a structure's answer differs from brute force, and the smallest case of such a difference.

namespace raylab {

/// Rays that one caller traces one after another. Mostly one ray suffices; a structure that remembers (mailboxes,
/// blockers) may need some before it.
struct StructureCase {
    Scene scene;
    std::vector<Ray> rays;
};

/// Two different answers to the last ray of a case.
struct Disagreement {
    std::string expected, found;
};

/// Describes what is wrong with a case; absent where nothing is.
using CaseJudge = std::function<std::optional<Disagreement>(const StructureCase&)>;

/// Compares a structure with the exact list, for the last ray of a case: the same primitive, the same bits of t, u and
/// v, and occluded() where there is a hit; and closest_of() and occluded_of() for all its rays.
CaseJudge judge_by_list(const StructureMethod& structure);

/// Compares the list with the oracle: the same primitive, and t within one float.
std::optional<Disagreement> judge_by_oracle(const StructureCase& asked);

/// Reduces a disagreement to few rays and few primitives, of which none can be left out.
StructureCase minimised(StructureCase failing, const CaseJudge& judge);

/// A caller that asks one structure about ray after ray, as the rendering of a picture does.
class StructureCaller {
public:
    explicit StructureCaller(const Accelerator& structure) : structure_(structure) { feeling_.toward(0); }

    /// A difference from the expected answer.
    std::optional<Disagreement> ask(const Ray& ray, const std::optional<Hit>& expected);

private:
    const Accelerator& structure_;
    Traversal seeing_, feeling_;
};

/// A ray to which closest_of() or occluded_of() gives another answer than expected.
struct TogetherDisagreement {
    std::size_t ray;
    Disagreement answers;
};
std::optional<TogetherDisagreement> disagreement_together(const Accelerator& structure, std::span<const Ray> rays,
                                                          std::span<const std::optional<Hit>> expected);

/// "nothing", "part 7 of object 0 at t = 0.5 (0x1p-1)".
std::string words(const std::optional<Hit>& hit);

}  // namespace raylab
