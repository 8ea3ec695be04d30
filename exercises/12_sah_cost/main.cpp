#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 12` starts it and judges what it says.
int main() {
    using namespace raylab::grading;
    return answer_cases(cuts::inputs, cuts::outputs,
                        [](auto input, auto output) { cuts::answer(&raylab::sah_cost, input, output); });
}
