#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

#include <functional>
#include <string>
#include <vector>

// What each pixel costs, as a picture.

namespace raylab {

/// A number a pixel: row 0 is the top, column 0 the left.
struct CostMap {
    int width = 0, height = 0;
    std::vector<double> costs = {};

    double& at(int x, int y);
    double at(int x, int y) const;
    double mean() const;
    double most() const;
};

/// What a traversal counts.
enum class Cost { primitive_tests, box_tests, steps };

/// "primitive tests", "box tests", "steps".
std::string words(Cost cost);
double counted(const Traversal& traversal, Cost cost);

/// cost(ray) of the eye ray through each pixel's middle; called from several threads.
CostMap cost_map(const CameraFrame& frame, int threads, const std::function<double(const Ray&)>& cost);

/// What a structure's closest() counts for the eye rays.
CostMap cost_map(const Accelerator& structure, const CameraFrame& frame, Cost cost, int threads);

/// A cost below which a `share` of all pixels of all maps lie: where several maps' colours are to mean the same.
double common_top(const std::vector<CostMap>& maps, double share = 0.995);

/// The map in false colours, black for 0, the lighter the more (in grey print, too), with a bar of colours and numbers
/// below it, `title` ("tests a pixel, octree"), the mean and the most. Costs from `top` on are nearly white; without one
/// it is common_top() of this map.
Image heat_map(const CostMap& map, const std::string& title, double top = 0);

}  // namespace raylab
