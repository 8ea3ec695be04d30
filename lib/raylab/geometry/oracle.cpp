#include "raylab/geometry/oracle.h"
