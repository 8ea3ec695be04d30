#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/radiosity/hierarchy/element_light.h"
#include "raylab/radiosity/hierarchy/known_links.h"
#include "raylab/radiosity/hierarchy/received.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace raylab {

struct HierarchyOptions {
    double error = 0.02;     // that a link may cause, relative to the scene's mean radiosity
    double smallest = 0.01;  // metres: no longest side of an element becomes shorter
    int rays = 8;            // shadow rays for a pair of elements; 0: nothing hides anything
    int light_points = 16;   // of each leaf, from which a shadow ray goes to every light
    double residual = 1e-6;  // the last iteration changes no radiosity by more, relative to the largest
    int threads = 0;
    MemoryLimit limit = {};
    std::function<void(const MemoryNeed&)> before_memory = {};  // is told what links will take, before they do
    KnownLinks* known = nullptr;  // what earlier runs have estimated; what this one does is added
};

/// What solving took and how good its answer is.
struct HierarchyWork {
    std::uint64_t links = 0;      // at the end
    std::uint64_t estimates = 0;  // pairs of elements that were looked at ...
    std::uint64_t known = 0;      // ... and how many of them earlier runs knew
    std::uint64_t rays = 0;       // shadow rays between elements
    double bytes = 0;             // the most that elements and links needed
    int rounds = 0;               // of refining and solving
    int iterations = 0;           // of gathering, in all rounds
    double residual = 0;          // of the last iteration
    double allowed = 0;           // the error of a link, in radiosity
    double largest_error = 0;     // of the sums of link errors at a leaf, in radiosity, and their mean by area ...
    double mean_error = 0;        // ... were all errors of one sign
};

/// A scene solved by hierarchical radiosity (Hanrahan, Salzman and Aupperle, A Rapid Hierarchical Radiosity Algorithm,
/// SIGGRAPH 91). Far elements exchange light as wholes; only near or bright ones do so by their parts. So n leaves need
/// a number of links in proportion to n, not n^2.
struct HierarchicalRadiosity {
    ElementTree elements;
    Links links;
    ElementLight light;
    std::vector<double> open;       // of each element: open_areas()
    std::vector<double> filled;     // of each element: the share of its view that its links and those above it fill
    std::vector<Color> background;  // the mean radiance that each element sees outside
    HierarchyWork work;
};

/// What comes to each element through its links and those above it: at a leaf, all that other elements send there.
std::vector<Color> gathered_light(const ElementTree& elements, const Links& links, const std::vector<double>& open,
                                  const Radiosities& radiosity, int threads);

/// Refines links and solves by turns, from a loose error to the one asked for (multigridding): a link is refined by
/// what it carries, and that is known from the coarser solution. It throws an Error as scene_radiosity() does, and
/// where links exceed the memory limit. The mesh has a root for each patch.
HierarchicalRadiosity hierarchical_radiosity(const PatchMesh& mesh, const PatchVisibility& visibility,
                                             const HierarchyOptions& options);

}  // namespace raylab
