#include "raylab/base/error.h"
#include "raylab/radiosity/solve/channel_groups.h"
#include "raylab/radiosity/solve/methods.h"
#include "raylab/radiosity/solve/second_matrix.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <numeric>
#include <vector>

namespace raylab {

namespace {

// The patches that reflect in this channel; the radiosity of the others is their emission.
std::vector<std::size_t> reflecting_patches(const RadiositySystem& system, int channel) {
    std::vector<std::size_t> patches;
    for (std::size_t i = 0; i < system.patches(); ++i)
        if (system.reflectance[i][channel] > 0) patches.push_back(i);
    return patches;
}

// sqrt(A_i / rho_i) of each: row i of (I - rho F) B = E times its square is symmetric, A_i / rho_i - A_i F_ij. Divided
// by the scales of its row and its column it has 1 - rho_i F_ii on the diagonal, and x_i = scale_i B_i.
std::vector<double> scales(const RadiositySystem& system, const std::vector<std::size_t>& patches, int channel) {
    std::vector<double> of_each;
    for (const std::size_t patch : patches)
        of_each.push_back(std::sqrt(system.area[patch] / system.reflectance[patch][channel]));
    return of_each;
}

// The upper triangle, whose columns lie in memory as the rows of form factors do.
Eigen::MatrixXd symmetric_matrix(const RadiositySystem& system, const std::vector<std::size_t>& patches,
                                 const std::vector<double>& scale) {
    const auto n = static_cast<Eigen::Index>(patches.size());
    Eigen::MatrixXd matrix(n, n);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto row = system.form_factors.row(patches[i]);
        const double factor = -system.area[patches[i]] / scale[i];
        double* column = matrix.data() + i * patches.size();
        for (std::size_t j = 0; j <= i; ++j) column[j] = factor * row[patches[j]] / scale[j];
        column[i] += 1;
    }
    return matrix;
}

// E_i + rho_i sum_j F_ij E_j over the patches that do not reflect, in the scale of the symmetric system.
Eigen::VectorXd right_side(const RadiositySystem& system, const std::vector<std::size_t>& patches,
                           const std::vector<double>& scale, int channel) {
    std::vector<double> from_black(system.patches());
    for (std::size_t j = 0; j < system.patches(); ++j)
        if (!(system.reflectance[j][channel] > 0)) from_black[j] = system.emission[j][channel];
    Eigen::VectorXd side(static_cast<Eigen::Index>(patches.size()));
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto row = system.form_factors.row(patches[i]);
        const double arriving = std::inner_product(row.begin(), row.end(), from_black.begin(), 0.0);
        side(static_cast<Eigen::Index>(i)) =
            scale[i] * (system.emission[patches[i]][channel] + system.reflectance[patches[i]][channel] * arriving);
    }
    return side;
}

}  // namespace

Solution by_cholesky(const RadiositySystem& system, const SolverOptions& options) {
    check_second_matrix(system, options);
    Solution solution{.solver = "cholesky", .radiosity = system.emission};
    for (const std::vector<int>& channels : channel_groups(system)) {
        const std::vector<std::size_t> patches = reflecting_patches(system, channels.front());
        if (patches.empty()) continue;
        const std::vector<double> scale = scales(system, patches, channels.front());
        Eigen::MatrixXd matrix = symmetric_matrix(system, patches, scale);
        const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Upper> factors(matrix);  // in place
        if (factors.info() != Eigen::Success)
            throw Error({"the radiosity system"}, "a positive definite matrix for the solver cholesky", "another one");
        for (const int channel : channels) {
            const Eigen::VectorXd scaled = factors.solve(right_side(system, patches, scale, channel));
            for (std::size_t i = 0; i < patches.size(); ++i)
                solution.radiosity[patches[i]][channel] = scaled(static_cast<Eigen::Index>(i)) / scale[i];
        }
    }
    return solution;
}

}  // namespace raylab
