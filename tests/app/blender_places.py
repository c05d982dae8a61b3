"""Imports a GLB file into Blender and writes where each object is in the first and the last frame, with y up.

Usage: blender -b --python blender_places.py -- FILE.glb PLACES.json LAST_FRAME
"""
import json
import sys

import bpy
import numpy

numpy.bool = bool  # Blender 3.4 uses the name that numpy 1.24 has dropped

glb, places, last = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.fps = 60
bpy.ops.import_scene.gltf(filepath=glb)
found = {}
for name, frame in (("first", 0), ("last", int(last))):
    scene.frame_set(frame)
    for thing in scene.objects:
        x, y, z = thing.matrix_world.translation
        found.setdefault(thing.name, {})[name] = [x, z, -y]
with open(places, "w") as file:
    json.dump(found, file)
