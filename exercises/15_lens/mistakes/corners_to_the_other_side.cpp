// hint: square_pulled_in
// What sticks out of the lens is moved by a radius along both axes, over the centre: they crowd around it.
#include "raylab/sampling/mapping/lens_point.h"

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    double a = 1 - 2 * v, b = 2 * u - 1;
    if (a * a + b * b > 1) {
        a += a < 0 ? 1 : -1;
        b += b < 0 ? 1 : -1;
    }
    return {a * radius, b * radius};
}
