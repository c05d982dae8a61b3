"""Eigenvectors of the separation tensors of a frame: in a bar under tension they are parallel to it."""
import numpy

import griffith


def principal_separations(frame):
    """Returns the largest eigenvalue [N] of each node's separation tensor and its unit eigenvector."""
    values, vectors = numpy.linalg.eigh(frame.separation_tensors)
    return values[:, -1], vectors[:, :, -1]


def angles_to_load():
    """Returns the angles between eigenvectors and load in the inner part of a bar under traction [rad]."""
    world = griffith.World(
        {
            "analysis": "static",
            "ground": None,
            "gravity": [0, 0, 0],
            "bodies": [
                {
                    "shape": {"box": {"size": [1, 0.2, 0.2], "element_size": 0.1}},
                    "material": {"preset": "concrete", "poisson_ratio": 0},
                    "supports": [{"region": {"half_space": {"point": [-0.5, 0, 0], "normal": [-1, 0, 0]}}}],
                    "loads": [
                        {
                            "kind": "traction",
                            "traction": [1e6, 0, 0],
                            "region": {"half_space": {"point": [0.5, 0, 0], "normal": [1, 0, 0]}},
                        }
                    ],
                }
            ],
        }
    ).run(1)
    frame = world.frame
    _, axes = principal_separations(frame)
    inner = numpy.abs(frame.positions[:, 0]) < 0.35
    return numpy.arccos(numpy.clip(numpy.abs(axes[inner, 0]), 0, 1))


if __name__ == "__main__":
    print(f"largest angle to the load: {numpy.degrees(angles_to_load()).max():.2g} degrees")
