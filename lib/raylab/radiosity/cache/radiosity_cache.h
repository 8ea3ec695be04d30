#pragma once

#include "raylab/radiosity/cache/cache_file.h"
#include "raylab/radiosity/hierarchy/hierarchical_radiosity.h"
#include "raylab/radiosity/patch_form_factors.h"
#include "raylab/radiosity/solve/solver.h"
#include "raylab/radiosity/system/row_sums.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// The form factors of a mesh as the solver takes them, what they took, and the row sums before and after scaling.
struct ScaledFormFactors {
    FormFactors factors;
    std::vector<double> scales;  // of each patch: F_ij was multiplied by those of i and j
    FormFactorWork work;
    RowSums before, after;
};

/// A folder in which the steps of solved scenes are kept between runs. A step's file is named by what the step is made
/// of: form factors by patches, what hides them and the options of form factors; a solution by these and by emission,
/// reflectances and the solver's options. Hierarchical radiosity keeps the links that any light has asked for, and its
/// solution. So a file is never asked for once anything has changed that it depends on,
/// and the camera, on which neither depends, changes nothing. A file that is damaged, or is something else, is computed
/// and written again, and sentences() says so.
class RadiosityCache {
public:
    /// The folder need not exist. It throws an Error for a path that cannot be one.
    explicit RadiosityCache(std::filesystem::path folder);

    std::optional<ScaledFormFactors> form_factors(const std::string& key, std::size_t patches);
    void keep(const std::string& key, const ScaledFormFactors& form_factors);

    std::optional<Solution> solution(const std::string& key, std::size_t patches);
    void keep(const std::string& key, const Solution& solution);

    /// Links between elements of a mesh's patches, from all runs so far; and what they came to in one light.
    std::optional<KnownLinks> links(const std::string& key);
    void keep(const std::string& key, const KnownLinks& links);

    std::optional<HierarchicalRadiosity> hierarchy(const std::string& key, const PatchMesh& mesh, double smallest);
    void keep(const std::string& key, const HierarchicalRadiosity& hierarchy);

    /// What was found wrong, a sentence for each file.
    const std::vector<std::string>& sentences() const { return sentences_; }

private:
    bool found(const std::filesystem::path& file, const std::string& head,
               const std::function<void(CacheReader&)>& read);

    std::filesystem::path folder_;
    std::vector<std::string> sentences_ = {};
};

/// What the form factors of a mesh depend on. `scaling` says how rows are scaled.
std::string form_factors_key(const PatchMesh& mesh, const FormFactorOptions& options, const std::string& scaling);

/// What links between elements of a mesh depend on.
std::string links_key(const PatchMesh& mesh, int rays);

/// What hierarchical radiosity depends on, whose links have the other key: it, the scene's light and its reflectances.
std::string hierarchy_key(const std::string& links, const PatchMesh& mesh, const HierarchyOptions& options);

/// What the solution of a system depends on, whose form factors have the other key.
std::string solution_key(const std::string& form_factors, const RadiositySystem& system, const std::string& solver,
                         const SolverOptions& options);

}  // namespace raylab
