"""A wall, a ball shot at it, and the resulting pieces."""
import sys

import griffith

world = griffith.World(sys.argv[1] if len(sys.argv) > 1 else "scenes/wall_small.json").run(60)
frame = world.frame
for mass in frame.body_masses:
    print(f"{mass:10.1f} kg")
print(f"{len(frame.body_masses)} pieces, highest utilization {frame.utilization.max():.3f}, state {world.state_hash}")
