// This file has no include guard. It is included inside a namespace, behind the function times(number, factor) that the
// formula calls: by sphere_filter.h for one sphere, and by row_spheres-inl.h for four at once and every instruction set
// (see triple_product-inl.h).

// A ray and a sphere: F(t) = a t^2 + 2 b t + c, negative inside, in plain doubles, and bounds on what rounding did to c
// and to the discriminant.
template <class Number>
struct SphereTerms {
    Number b, distance, c, c_error, discriminant, discriminant_error;  // distance is the square of the origin's
};

// Of the ray's direction d and the way f from the sphere's center to its origin; a is d.d.
//
// Each coordinate of f carries one rounding; r r and the squares of d are exact (48 bits). Counting roundings per
// monomial, with u = 2^-53 and one to spare in each for the bounds' own rounding:
//   a: 2 (sums)                                      b: f 1, product 1, sums 2: 4 u |f|.|d|, at most 4 u sqrt(a f.f)
//   c: f 2, product 1, sums 2: 5 u f.f, and 2 u |c|: at most 8 u (f.f + r^2)
//   discriminant, b^2: twice b's, and 1: 9 u a f.f
//   ... a c: c's 5 u f.f, a times; c's last 1, a's 2 and the product's 1, of a |c|, |c| at most f.f + r^2:
//   9 u a f.f + 4 u a r^2
//   ... the last difference, at most a (f.f + r^2), 1. All together 19 u a (f.f + r^2); with what is to spare at
//   most 24.
// (By Lagrange's identity b^2 - a c is a r^2 - |d x f|^2, too, which mostly cancels less. But the bound of its error by
// lengths alone is the same, and it takes thirteen operations more.)
// Products of four floats stay between 2^-596 and 2^520: nothing under- or overflows.
template <class Number>
[[gnu::always_inline]] inline SphereTerms<Number> sphere_terms(Number dx, Number dy, Number dz, Number fx, Number fy,
                                                               Number fz, Number a, Number squared_radius) {
    const Number distance = fx * fx + fy * fy + fz * fz, b = dx * fx + dy * fy + dz * fz;
    const Number error = times(distance + squared_radius, 8 * 0x1p-53);
    const Number c = distance - squared_radius;
    return {b, distance, c, error, b * b - a * c, times(a * error, 3)};
}
