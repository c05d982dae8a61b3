"""A tension test: a bar is pulled ever harder until it breaks, at the tensile strength of its material."""
import griffith


def breaking_stress(low=0.5, high=1.5, tolerance=0.01):
    """Returns the traction that breaks a bar, by bisection, and the strength of its material [Pa]."""
    scene = griffith.Scene(
        {
            "analysis": "static",
            "ground": None,
            "gravity": [0, 0, 0],
            "bodies": [
                {
                    "shape": {"box": {"size": [1, 0.2, 0.2], "element_size": 0.1}},
                    # Without lateral contraction a held end disturbs nothing.
                    "material": {"preset": "concrete", "poisson_ratio": 0},
                    "supports": [{"region": {"half_space": {"point": [-0.5, 0, 0], "normal": [-1, 0, 0]}}}],
                    "loads": [
                        {
                            "kind": "traction",
                            "traction": [1, 0, 0],
                            "region": {"half_space": {"point": [0.5, 0, 0], "normal": [1, 0, 0]}},
                        }
                    ],
                }
            ],
        }
    )
    strength = scene.bodies[0].material.tensile_strength
    low, high = low * strength, high * strength
    while high - low > tolerance * strength:
        middle = (low + high) / 2
        scene.bodies[0].loads[0].traction = [middle, 0, 0]
        broke = len(griffith.World(scene).run(1).frame.crack_steps) > 0
        low, high = (low, middle) if broke else (middle, high)
    return (low + high) / 2, strength


if __name__ == "__main__":
    measured, strength = breaking_stress()
    print(f"breaks at {measured / 1e6:.3f} MPa, strength {strength / 1e6:.3f} MPa")
