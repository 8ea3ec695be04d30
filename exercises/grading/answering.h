#pragma once

#include "work_task.h"

namespace raylab::grading {

/// The student's side of the pipe: `inputs` doubles for each case are read from standard input until it ends, and
/// `outputs` doubles for each case are written to what was standard output when the program began. Text that the
/// function prints goes to stderr, so that it can never be taken for an answer. Exit code 3: the function threw
/// Unfinished ("not written yet"); 4: it threw something else; 5: it was
/// refused more memory.
int answer_cases(std::size_t inputs, std::size_t outputs, const Answer& answer);

/// Counted work: the number of calls that each task may make is read from standard input; the function's answers,
/// `outputs` doubles each, are written in the order of the calls. The exit codes are as above.
int answer_work(const std::vector<WorkTask>& tasks, std::size_t outputs, const Answer& answer);

inline constexpr int exit_unfinished = 3;
inline constexpr int exit_thrown = 4;
inline constexpr int exit_out_of_memory = 5;
/// With exit code 4 the last line on stderr begins with this, and says what was thrown.
inline constexpr const char* thrown_words = "an exception was thrown: ";

}  // namespace raylab::grading
