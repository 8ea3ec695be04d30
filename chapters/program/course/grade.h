#pragma once

#include "raylab/base/command_line.h"
#include "raylab/base/program.h"

#include <string>
#include <vector>

namespace raylab {

/// `raylab grade --class FOLDER -o REPORT`: all submissions of a class, or of a part of it.
ExitCode grade_class(const Arguments& arguments);

/// `raylab grade --merge PART... -o REPORT`: the tables and pages of parts that were graded one by one.
ExitCode merge_reports(const Arguments& arguments);

}  // namespace raylab
