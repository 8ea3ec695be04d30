#pragma once

#include "raylab/radiosity/direct_light.h"
#include "raylab/radiosity/hierarchy/hierarchical_radiosity.h"
#include "raylab/radiosity/hierarchy/link_refinement.h"

#include <array>
#include <vector>

namespace raylab {

/// The elements of a scene with their links and their light, between the steps of hierarchical_radiosity(). The same
/// for any number of threads: they estimate and gather, and what they found is put in place in one order.
class LinkedElements {
public:
    LinkedElements(const PatchMesh& mesh, const PatchVisibility& visibility, const HierarchyOptions& options);

    /// The error in radiosity that a link may cause: options.error of the mean radiosity of a closed scene that emits
    /// what this one does and reflects it evenly. 0 where nothing emits.
    double allowed() const { return allowed_; }

    /// Links all pairs of roots that see each other, or their quarters, with an error `looser` times the allowed one.
    void link_roots(double looser);

    /// Replaces each link whose error exceeds `looser` times the allowed one by links of quarters. True if there was
    /// one.
    bool refine(double looser);

    /// Gathers, pushes and pulls until an iteration changes no radiosity by more than this, relative to the largest.
    void solve(double residual);

    HierarchicalRadiosity result() &&;

private:
    struct Candidate {
        Link link = {};
        Refinement refinement = Refinement::none;
        KnownLinks::Known what_is_known;
        bool is_estimated_now = false, is_measured_now = false;  // not known before
    };

    void add_state(std::size_t element);
    std::uint32_t quarter(std::uint32_t element);
    double ambient() const;
    void look_around();
    void quarter_under_lights();
    void link_pairs(std::vector<LinkEnds> pairs, double looser);
    std::vector<Candidate> estimated(const std::vector<LinkEnds>& pairs, double looser);
    Candidate candidate(const LinkEnds& ends, double looser, Traversal& traversal) const;
    KnownLinks::Pair numbers(const LinkEnds& ends) const;
    std::array<LinkEnds, 4> quarter_pairs(const LinkEnds& ends, Refinement refinement);
    MemoryNeed need(std::size_t pairs) const;
    void claim_memory(std::size_t pairs);
    std::vector<double> filled(const std::vector<double>& open) const;
    void sum_errors(const std::vector<double>& open);

    const PatchMesh& mesh_;
    const PatchVisibility& visibility_;
    const HierarchyOptions& options_;
    PatchLights lights_;
    ElementTree elements_;
    Links links_ = {};
    ElementLight light_ = {};
    std::vector<ArrivingLight> direct_ = {};
    std::vector<double> open_shares_ = {};
    std::vector<Color> backgrounds_ = {};     // the mean radiance that an element sees outside
    std::size_t looked_ = 0;                  // the number of elements that have looked around
    std::size_t quartered_under_lights_ = 0;  // the number of elements of which this was asked
    double allowed_ = 0;
    double stated_ = 1e6;  // bytes: of what is said to be needed; less is not worth a word
    HierarchyWork work_ = {};
};

}  // namespace raylab
