#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 04` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(normals::inputs, normals::outputs,
                        [](auto input, auto output) { normals::answer(&raylab::transformed_normal, input, output); });
}
