#pragma once

#include "formats.h"

#include "raylab/base/command_line.h"
#include "raylab/base/program.h"

#include <string>
#include <vector>

namespace raylab {

/// What an answer that passes is worth: --points.
grading::Hundredths points_asked_for(const Arguments& arguments);

/// `raylab grade --class FOLDER -o REPORT`: all submissions of a class, or of a part of it.
ExitCode grade_class(const Arguments& arguments);

/// `raylab grade --merge PART... -o REPORT`: the tables and pages of parts that were graded one by one.
ExitCode merge_reports(const Arguments& arguments);

/// `raylab grade --scene ...` and `--reference-dir ...`: pictures, or a renderer that draws them.
grading::Grade graded_pictures(const Arguments& arguments, const grading::Isolation& isolation,
                               grading::Hundredths most);

}  // namespace raylab
