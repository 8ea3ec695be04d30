#pragma once

#include "raylab/radiosity/form_factors.h"
#include "raylab/radiosity/visibility.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

struct FormFactorOptions {
    std::string method = "auto";  // exchange_by_distance(), or as form_factor_method_named()
    int rays = 8;                 // shadow rays for a pair of patches that face each other; 0: nothing hides anything
    int effort = 0;               // of the named method: pairs, pixels a side, ...; 0: the most that its chart shows
    int threads = 0;              // 0: all cores; the same bits for any number
    std::string label = {};       // of the progress bar; empty: none
};

/// What the form factors took.
struct FormFactorWork {
    std::uint64_t links = 0;  // pairs of patches, in one direction, that see each other
    std::uint64_t rays = 0;   // shadow rays
    double seconds = 0;
    // By how much a row's sum may be wrong: by the factors in full view alone, and with four standard deviations of the
    // shadow rays in the worst row.
    double error_in_full_view = 0, error = 0;
};

struct CountedFormFactors {
    FormFactors factors;
    FormFactorWork work;
};

/// Form factors of a mesh of which another was made by quartering some patches. What two patches exchange that are in
/// both is the same.
struct KnownFormFactors {
    const FormFactors& factors;
    const std::vector<double>& scales;  // F_ij was multiplied by those of i and j
    FormFactorWork work;
    std::vector<std::optional<std::uint32_t>> before;  // of each patch of the new mesh: its number in the old one
};

/// The form factors of all patches: of each pair the factor in full view, times the share of shadow rays that pass. By
/// "auto" A_i F_ij = A_j F_ji is computed once for both patches. A hemicube sees what hides what by itself, so no
/// shadow rays are cast. Of what is known, if anything is, only pairs with a new patch are computed, and the work is
/// that of both meshes; a hemicube's rows are all computed. It throws an Error that lists the methods, and for a
/// pair that a closed form does not know.
CountedFormFactors patch_form_factors(const PatchMesh& mesh, const PatchVisibility& visibility,
                                      const FormFactorOptions& options, const KnownFormFactors* known = nullptr);

/// A_i F_ij of two patches in full view of each other, m^2, with an error of at most some thousandths: a contour
/// integral seen from the smaller patch's centre where they are far apart, from more of its points the nearer they are
/// (of squares that share an edge 36 leave .0006 at 30 degrees, and less at more), and the double contour integral
/// between plates that nearly touch.
double exchange_by_distance(const Patch& a, const Patch& b);

/// Whether some point of each patch lies in front of the other; if not, their form factors are zero.
bool face_each_other(const Patch& a, const Patch& b);

}  // namespace raylab
