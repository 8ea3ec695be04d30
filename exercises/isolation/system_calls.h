#pragma once

namespace raylab::grading {

/// Who the filter is for.
enum class Work {
    compile,          // a compiler, an assembler, a linker: they start each other and open files
    answer,           // a linked program: it computes, reads and writes what is open already, and may start threads
    load_and_answer,  // the same for a program that its loader completes: it may open files, too
    draw,             // a chapter's program: it reads the project and writes charts
    render,           // a student's whole renderer: it reads the scene in its folder, and writes a picture there
};

/// Whether such a program may write files into its folder.
inline bool may_write(Work work) { return work == Work::compile || work == Work::draw || work == Work::render; }

/// Refuses, to this process and those that it starts, the system calls that this work has no need of. What reaches into
/// other processes or changes the machine kills the process (SIGSYS), the rest fails as if there was no right to it. It
/// throws std::system_error where the kernel refuses.
void filter_system_calls(Work work);

}  // namespace raylab::grading
