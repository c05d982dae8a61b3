"""The lowest speed of a ball that breaks a plate of concrete, by the thickness of the plate, with a plot."""
import sys

import numpy

import griffith


def plate(thickness):
    """Returns a scene of a free plate of 1 m and a ball of 5 kg flying at its center."""
    return griffith.Scene(
        {
            "gravity": [0, 0, 0],
            "ground": None,
            "bodies": [
                {
                    "shape": {"box": {"size": [1, 1, thickness], "element_size": [0.2, 0.2, thickness]}},
                    "material": "concrete",
                }
            ],
            "projectiles": [{"position": [0, 0, 0.3], "direction": [0, 0, -1], "mass": 5, "radius": 0.1}],
            "simulation": {"time_step": 1 / 120},
        }
    )


def breaking_speeds(thicknesses=(0.05, 0.1, 0.15, 0.2), tolerance=0.05):
    """Returns thicknesses [m] and the speeds from which the ball makes pieces [m/s], within a relative tolerance."""
    speeds = []
    for thickness in thicknesses:
        scene = plate(thickness)
        low, high = 0.1, 200.0
        while high > (1 + tolerance) * low:
            scene.projectiles[0].speed = (low * high) ** 0.5
            broke = len(griffith.World(scene).run(12).frame.body_masses) > 1
            low, high = (low, scene.projectiles[0].speed) if broke else (scene.projectiles[0].speed, high)
        speeds.append((low * high) ** 0.5)
    return numpy.array(thicknesses), numpy.array(speeds)


if __name__ == "__main__":
    thickness, speed = breaking_speeds()
    for row in zip(thickness, speed):
        print("{:.2f} m: {:.2f} m/s".format(*row))
    from matplotlib import pyplot

    pyplot.plot(1000 * thickness, speed, "o-")
    pyplot.xlabel("thickness [mm]")
    pyplot.ylabel("breaking speed [m/s]")
    pyplot.title("Plate of concrete, 1 m, ball of 5 kg")
    pyplot.savefig(sys.argv[1] if len(sys.argv) > 1 else "breaking_speed.png", dpi=150)
