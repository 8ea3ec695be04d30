#include "raylab/base/program.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/heap.h"
#include "raylab/base/interrupt.h"
#include "raylab/base/print.h"
#include "raylab/base/printable.h"
#include "raylab/base/standard_streams.h"

#include <cstdio>
#include <exception>
#include <new>

namespace raylab {

namespace {

ExitCode answer(const std::function<ExitCode()>& body) {
    try {
        return body();
    } catch (const HelpWanted& help) {
        print_text(help.text);
        return ExitCode::as_it_should_be;
    }
}

}  // namespace

int run_program(const std::function<ExitCode()>& body) {
    open_missing_standard_streams();
    keep_freed_memory();
    end_at_interrupt();
    try {
        const ExitCode code = answer(body);
        flush_standard_output();
        return static_cast<int>(code);
    } catch (const EndQuietly&) {
    } catch (const std::bad_alloc&) {
        const Uninterrupted while_said;
        std::fputs("raylab: not enough memory\n", stderr);
    } catch (const std::exception& error) {
        // An interrupt removes files that other threads then miss; they must not report it.
        const Uninterrupted while_said;
        print_note("raylab: " + printable(error.what()) + "\n");
    }
    return static_cast<int>(ExitCode::could_not);
}

}  // namespace raylab
