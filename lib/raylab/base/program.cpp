#include "raylab/base/program.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"

#include <cstdio>
#include <exception>
#include <new>

namespace raylab {

int run_program(const std::function<ExitCode()>& body) {
    try {
        return static_cast<int>(body());
    } catch (const HelpWanted& help) {
        std::fputs(help.text.c_str(), stdout);
        return static_cast<int>(ExitCode::as_it_should_be);
    } catch (const std::bad_alloc&) {
        std::fputs("raylab: not enough memory\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "raylab: %s\n", error.what());
    }
    return static_cast<int>(ExitCode::could_not);
}

}  // namespace raylab
