#pragma once

// Tetrahedral meshes: shapes, files, topology, reports.

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/box_pattern.h"
#include "sim/mesh/hex_mesh.h"
#include "sim/mesh/mesh_cells.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/read_mesh.h"
#include "sim/mesh/shapes.h"
#include "sim/mesh/tet_edges.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/mesh/topology.h"
#include "sim/mesh/write_mesh.h"
#include "sim/meshing/meshing_options.h"
