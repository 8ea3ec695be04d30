#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

#include <functional>
#include <string>
#include <vector>

// The cost of each pixel, as a picture.

namespace raylab {

/// A number for each pixel: row 0 is the top, column 0 the left.
struct CostMap {
    int width = 0, height = 0;
    std::vector<double> costs = {};

    double& at(int x, int y);
    double at(int x, int y) const;
    double mean() const;
    double largest() const;
};

/// A count of a traversal.
enum class Cost { primitive_tests, box_tests, steps };

/// "primitive tests", "box tests", "steps".
std::string words(Cost cost);
double counted(const Traversal& traversal, Cost cost);

/// The cost(ray) of the eye ray through each pixel's center; `cost` is called from several threads.
CostMap cost_map(const CameraFrame& frame, int threads, const std::function<double(const Ray&)>& cost);

/// The count of a structure's closest() for each eye ray.
CostMap cost_map(const Accelerator& structure, const CameraFrame& frame, Cost cost, int threads);

/// The cost below which a `share` of all pixels of all maps lie: the common top of several maps whose colours are to
/// mean the same.
double common_top(const std::vector<CostMap>& maps, double share = 0.995);

/// The map in false colours: black for 0, and the higher the cost the lighter (in grey print, too), by its square root.
/// A narrow map is enlarged. Below it are a bar of colours with numbers, `title` ("tests a pixel, octree"), the mean
/// and the maximum. Costs from `top` on are nearly white; without one it is common_top() of this map.
Image heat_map(const CostMap& map, const std::string& title, double top = 0);

}  // namespace raylab
