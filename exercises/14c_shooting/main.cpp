#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 14c` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(shooting::inputs, shooting::outputs,
                        [](auto input, auto output) { shooting::answer(&raylab::shooting_step, input, output); });
}
