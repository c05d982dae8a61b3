"""A data set of shots at a wall: position and speed, resulting pieces and cracks, in one .npz file."""
import sys

import numpy

import griffith

WALL = {
    "bodies": [
        {
            "shape": {"box": {"size": [3, 3, 0.5], "element_size": [0.75, 0.75, 0.5]}},
            "position": [0, 1.5, 0],
            "material": {"preset": "brick", "tensile_strength": 60000, "fracture_toughness": 180000},
            "supports": [{"region": {"half_space": {"point": [0, -1.5, 0], "normal": [0, -1, 0]}}}],
        }
    ],
    "simulation": {"time_step": 1 / 120},
}


def write_dataset(path, shots=200, seed=1):
    """Writes `shots` random shots.

    Arrays: position (n, 2) of the impact [m], speed [m/s], mass [kg], pieces, kinetic_energy [J]; the cracks of shot i
    are crack_position and crack_normal from first_crack[i] to first_crack[i + 1].
    """
    random = numpy.random.default_rng(seed)
    position = random.uniform((-1.2, 0.4), (1.2, 2.6), (shots, 2))
    speed = random.uniform(5, 60, shots)
    mass = random.uniform(5, 30, shots)
    start = griffith.World(WALL)
    pieces, energies, positions, normals, first_crack = [], [], [], [], [0]
    for i in range(shots):
        world = start.copy()
        world.fire(position=[*position[i], 1.0], direction=[0, 0, -1], speed=speed[i], mass=mass[i])
        frame = world.run(30).frame
        pieces.append(len(frame.body_masses))
        energies.append(frame.energy_kinetic)
        positions.append(frame.crack_positions.copy())  # views end with the world
        normals.append(frame.crack_normals.copy())
        first_crack.append(first_crack[-1] + len(positions[-1]))
    numpy.savez_compressed(
        path,
        position=position,
        speed=speed,
        mass=mass,
        pieces=pieces,
        kinetic_energy=energies,
        first_crack=first_crack,
        crack_position=numpy.concatenate(positions),
        crack_normal=numpy.concatenate(normals),
    )


if __name__ == "__main__":
    write_dataset(sys.argv[1] if len(sys.argv) > 1 else "shots.npz")
