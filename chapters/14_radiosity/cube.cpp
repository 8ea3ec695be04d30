#include "cube.h"

#include "squares.h"

#include "raylab/radiosity/form_factor/polygon_form_factor.h"

#include <utility>
#include <vector>

namespace raylab::cornell {

// The opposite face is seen under the factor of parallel squares, the others share the rest.
RadiositySystem cube(double reflectance, double row) {
    const double opposite = polygon_form_factor(lower_square(), upper_square(1)), beside = (1 - opposite) / 4;
    FormFactors factors(6);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) factors.at(i, j) = i == j ? 0 : row * (i / 2 == j / 2 ? opposite : beside);
    std::vector<Color> emission(6, Color(0));
    emission[0] = Color(1);
    return {std::vector<double>(6, 1), emission, std::vector<Color>(6, Color(reflectance)), std::move(factors)};
}

}  // namespace raylab::cornell
