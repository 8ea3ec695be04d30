#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 05c` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(mesh_hit::inputs, mesh_hit::outputs,
                        [](auto input, auto output) { mesh_hit::answer(&raylab::gouraud_and_phong, input, output); });
}
