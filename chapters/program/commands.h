#pragma once

#include "raylab/base/program.h"

#include <functional>
#include <string>
#include <vector>

namespace raylab {

/// A command of the `raylab` program; `words` are the command line after its name.
struct Command {
    std::string name;
    std::string about;  // one line of help
    std::function<ExitCode(const std::vector<std::string>& words)> run;
};

// Each command is in a file of the same name.
ExitCode tour_command(const std::vector<std::string>& words);
ExitCode chapter_command(const std::vector<std::string>& words);
ExitCode slides_command(const std::vector<std::string>& words);
ExitCode chart_command(const std::vector<std::string>& words);
ExitCode stability_command(const std::vector<std::string>& words);
ExitCode stability_accelerators(const std::vector<std::string>& words);  // the words after "stability accelerators"
ExitCode render_command(const std::vector<std::string>& words);
ExitCode merge_command(const std::vector<std::string>& words);
ExitCode radiosity_command(const std::vector<std::string>& words);
ExitCode form_factor_command(const std::vector<std::string>& words);
ExitCode needs_command(const std::vector<std::string>& words);
ExitCode tree_command(const std::vector<std::string>& words);
ExitCode compare_command(const std::vector<std::string>& words);
ExitCode trace_command(const std::vector<std::string>& words);
ExitCode bench_command(const std::vector<std::string>& words);
ExitCode export_command(const std::vector<std::string>& words);
ExitCode doctor_command(const std::vector<std::string>& words);
ExitCode check_command(const std::vector<std::string>& words);
ExitCode watch_command(const std::vector<std::string>& words);
ExitCode grade_command(const std::vector<std::string>& words);
ExitCode handout_command(const std::vector<std::string>& words);
ExitCode package_command(const std::vector<std::string>& words);

}  // namespace raylab
