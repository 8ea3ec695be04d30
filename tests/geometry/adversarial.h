#pragma once

#include "raylab/geometry/adversarial.h"
