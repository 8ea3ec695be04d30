#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 12b` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(halves::inputs, halves::outputs,
                        [](auto input, auto output) { halves::answer(&raylab::visited_halves, input, output); });
}
