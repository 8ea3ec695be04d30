#include "raylab/radiosity/solve/channel_groups.h"
#include "raylab/radiosity/solve/methods.h"
#include "raylab/radiosity/solve/second_matrix.h"

#include <Eigen/LU>

namespace raylab {

// (I - rho F) B = E, as it stands.
Solution by_elimination(const RadiositySystem& system, const SolverOptions& options) {
    check_second_matrix(system, options);
    Solution solution{.solver = "elimination", .radiosity = system.emission};
    const auto n = static_cast<Eigen::Index>(system.patches());
    if (n == 0) return solution;
    Eigen::MatrixXd matrix(n, n);
    for (const std::vector<int>& channels : channel_groups(system)) {
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto patch = static_cast<std::size_t>(i);
            const auto row = system.form_factors.row(patch);
            matrix.row(i) =
                -system.reflectance[patch][channels.front()] * Eigen::Map<const Eigen::RowVectorXd>(row.data(), n);
            matrix(i, i) += 1;
        }
        const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> factors(matrix);  // in place
        for (const int channel : channels) {
            Eigen::VectorXd emission(n);
            for (Eigen::Index i = 0; i < n; ++i) emission(i) = system.emission[static_cast<std::size_t>(i)][channel];
            const Eigen::VectorXd radiosity = factors.solve(emission);
            for (Eigen::Index i = 0; i < n; ++i)
                solution.radiosity[static_cast<std::size_t>(i)][channel] = radiosity(i);
        }
    }
    return solution;
}

}  // namespace raylab
