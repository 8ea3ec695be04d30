#pragma once

#include "raylab/geometry/vector.h"

// The integral of ln r over two edges, with r the distance of a point of one from a point of the other. Form factors
// between polygons are sums of it.

namespace raylab {

struct PolygonEdge {
    Vec3d start, direction;  // of length 1
    double length;
};

/// In closed form, for any two edges; where their lines are skew with dilogarithms (Schroeder and Hanrahan, "On the
/// Form Factor between Two Polygons", SIGGRAPH 93; derived otherwise, in edge_pair.cpp). Weak spot: the error is some
/// 1e-16 times the square of the distance from where the two lines come nearest to the edges' far ends, which is large
/// for lines that are nearly parallel.
double edge_pair_closed(const PolygonEdge& a, const PolygonEdge& b);

/// The distance on which the error of edge_pair_closed() depends; for parallel lines that of the edges.
double edge_pair_reach(const PolygonEdge& a, const PolygonEdge& b);

/// The inner integral in closed form; the outer one numerical, split where a singularity of the integrand comes
/// nearest, so that edges which touch are no special case. It takes ten times as long, and loses nothing between lines
/// that are nearly parallel.
double edge_pair_numerical(const PolygonEdge& a, const PolygonEdge& b);

}  // namespace raylab
