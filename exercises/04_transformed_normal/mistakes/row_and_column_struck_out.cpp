// hint: checkerboard
// Strikes out a row and a column for each entry, and takes what is left over the determinant as it is.
#include "raylab/geometry/transformed_normal.h"

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const glm::dmat3 m(columns[0], columns[1], columns[2]);
    const auto minor = [&m](int column, int row) {
        glm::dmat2 rest;
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j) rest[i][j] = m[i < column ? i : i + 1][j < row ? j : j + 1];
        return glm::determinant(rest);
    };
    Vec3d carried(0);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) carried[row] += minor(column, row) * normal[column];
    return glm::normalize(carried / glm::determinant(m));
}
