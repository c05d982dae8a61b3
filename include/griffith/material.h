#pragma once

// Materials, and the stress and separation of elements and nodes made of them.

#include "sim/elasticity/element.h"
#include "sim/elasticity/material.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/elasticity/quadratic_element.h"
#include "sim/fracture/node_separation.h"
#include "sim/fracture/separation_tensor.h"
#include "sim/fracture/strength_surface.h"
#include "sim/fracture/strength_variation.h"
