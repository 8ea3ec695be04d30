#pragma once

// Form factors in closed form. The numbers C-11, C-14, ... are those of J. R. Howell, "A Catalog of Radiation Heat
// Transfer Configuration Factors".

namespace raylab {

/// Equal rectangles that face each other (C-11); x and y are their sides, in units of their distance. As printed: for
/// small sides its terms cancel, and at x = y = 1e-4 nothing is left.
double parallel_rectangles_textbook(double x, double y);

/// The same to twelve digits for any sides. Where the smaller side is at most 1, one of the integrals is done by Gauss
/// points in place of the closed form: its integrand has one sign, so nothing cancels.
double parallel_rectangles(double x, double y);

/// From a rectangle of width w to a perpendicular one of height h that shares an edge with it (C-14), both in units of
/// that edge's length. Weak spot: w or h below 1e-2, or above 1e2, where the terms cancel.
double perpendicular_rectangles(double h, double w);

/// From a disk to a coaxial parallel one at a distance (C-41), in a form that does not cancel.
double coaxial_disks(double from_radius, double to_radius, double distance);

/// From a sphere to a disk; the distance is that from the sphere's centre to the disk's, and the disk faces the sphere.
double sphere_to_disk(double disk_radius, double distance);

/// From a small patch to a disk that faces it; its axis passes through the patch.
double element_to_disk(double disk_radius, double distance);

/// From a small patch to a parallel rectangle of sides a and b at a distance; a corner is straight above the patch.
double element_to_parallel_rectangle(double a, double b, double distance);

/// From a small patch to a perpendicular rectangle that stands on the patch's plane: of this height and width, at this
/// distance, one lower corner opposite to the patch.
double element_to_perpendicular_rectangle(double height, double width, double distance);

/// From a small patch to a sphere at a distance, from the patch to its centre; `angle`, in radians, is that between
/// the patch's normal and the direction to the centre. Part of the sphere may lie below the horizon.
double element_to_sphere(double radius, double distance, double angle);

}  // namespace raylab
