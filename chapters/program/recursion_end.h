#pragma once

#include "raylab/base/command_line.h"

#include <string>

namespace raylab {

/// Where the recursion ends, as a command's options say it.
struct RecursionEnd {
    int depth;         // the greatest depth; the eye ray has depth 1
    double threshold;  // a ray is followed while its throughput is above this
};

struct RecursionEndOptions {
    std::string threshold;  // the name of the command's option: "--threshold"
    int deepest = 1000;     // the greatest --depth that is taken
};

/// Without both options: 32 and 1/256, the numbers of `raylab needs`. A picture that names its depth is followed
/// down to it, whatever the throughput, so that it can be compared with the picture of any other program. A threshold
/// alone ends rays by throughput, at depth 32 at the latest.
RecursionEnd recursion_end(const Arguments& arguments, const RecursionEndOptions& options);

/// "rays are followed to depth 5", or to a depth and a throughput.
std::string in_words(const RecursionEnd& end);

}  // namespace raylab
