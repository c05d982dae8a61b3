"""Types of a frame's attributes, for editors. A test compares their names with the library's."""
from typing import Any, NamedTuple

import numpy
from numpy.typing import NDArray

class Info(NamedTuple):
    name: str
    unit: str
    meaning: str

ARRAYS: dict[str, Info]
VALUES: dict[str, Info]
QUANTITIES: dict[str, Info]

class Frame:
    def __init__(self, world: Any) -> None: ...
    def quantity(self, name: str) -> NDArray[numpy.float64]: ...
    positions: NDArray[numpy.float64]
    rest_positions: NDArray[numpy.float64]
    velocities: NDArray[numpy.float64]
    masses: NDArray[numpy.float64]
    utilization: NDArray[numpy.float64]
    separation_tensors: NDArray[numpy.float64]
    separation_normals: NDArray[numpy.float64]
    separation_stress: NDArray[numpy.float64]
    resistance: NDArray[numpy.float64]
    reactions: NDArray[numpy.float64]
    has_support: NDArray[numpy.uint8]
    at_crack_front: NDArray[numpy.uint8]
    tets: NDArray[numpy.int32]
    tet_neighbors: NDArray[numpy.int32]
    tet_bodies: NDArray[numpy.int32]
    stress: NDArray[numpy.float64]
    body_positions: NDArray[numpy.float64]
    body_orientations: NDArray[numpy.float64]
    body_velocities: NDArray[numpy.float64]
    body_angular_velocities: NDArray[numpy.float64]
    body_masses: NDArray[numpy.float64]
    body_parents: NDArray[numpy.int32]
    body_scene_bodies: NDArray[numpy.int32]
    body_is_rigid: NDArray[numpy.uint8]
    body_is_asleep: NDArray[numpy.uint8]
    body_is_supported: NDArray[numpy.uint8]
    crack_steps: NDArray[numpy.int64]
    crack_times: NDArray[numpy.float64]
    crack_nodes: NDArray[numpy.int32]
    crack_bodies: NDArray[numpy.int32]
    crack_positions: NDArray[numpy.float64]
    crack_normals: NDArray[numpy.float64]
    crack_loads: NDArray[numpy.float64]
    crack_resistance: NDArray[numpy.float64]
    contact_bodies_a: NDArray[numpy.int32]
    contact_bodies_b: NDArray[numpy.int32]
    contact_positions: NDArray[numpy.float64]
    contact_normals: NDArray[numpy.float64]
    contact_impulses: NDArray[numpy.float64]
    projectile_positions: NDArray[numpy.float64]
    projectile_velocities: NDArray[numpy.float64]
    projectile_rotations: NDArray[numpy.float64]
    projectile_radii: NDArray[numpy.float64]
    projectile_masses: NDArray[numpy.float64]
    surface_positions: NDArray[numpy.float32]
    surface_normals: NDArray[numpy.float32]
    surface_triangles: NDArray[numpy.int32]
    surface_is_crack: NDArray[numpy.uint8]
    surface_first_vertices: NDArray[numpy.int32]
    surface_vertex_counts: NDArray[numpy.int32]
    surface_first_triangles: NDArray[numpy.int32]
    surface_triangle_counts: NDArray[numpy.int32]
    surface_versions: NDArray[numpy.int32]
    step: float
    time: float
    time_step: float
    bodies: float
    cracks: float
    mass: float
    momentum_x: float
    angular_momentum_x: float
    momentum_y: float
    angular_momentum_y: float
    momentum_z: float
    angular_momentum_z: float
    energy_kinetic: float
    energy_elastic: float
    energy_start: float
    energy_gravity: float
    energy_loads: float
    energy_supports: float
    energy_projectiles: float
    energy_edits: float
    energy_plastic: float
    energy_contacts: float
    energy_material_damping: float
    energy_fracture: float
    energy_microstep_damping: float
    energy_time_integration: float
    energy_hand_over: float
    energy_scaling: float
    energy_limited: float
    energy_fracture_energy: float
    energy_unaccounted: float
    step_substeps: float
    step_microsteps: float
    step_microstep_work: float
    step_impacts: float
    step_contacts: float
    step_cracks_postponed: float
    step_cracks_suppressed: float
    step_remeshing_refused: float
    step_supports_torn: float
    step_unfinished_equilibria: float
    step_unfinished_explicit: float
    step_unconverged_solves: float
    step_unconverged_motions: float
    step_unconverged_contacts: float
    step_contact_iterations: float
    step_sleeping_bodies: float
    step_max_penetration: float
    step_max_relative_residual: float
    step_solver_iterations: float
    step_inverted_tets: float
    step_relieved_tets: float
    step_non_finite_values: float
