#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 07d` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(branches::inputs, branches::outputs,
                        [](auto input, auto output) { branches::answer(&raylab::followed_branches, input, output); });
}
