import griffith

world = griffith.World("scenes/glass_pane.json")
world.run(60)
print(world.frame.utilization.max(), world.frame.body_masses)
