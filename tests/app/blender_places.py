"""Imports a GLB file into Blender and writes where each object and the lower corner of what is seen of it are in the
first and the last frame, with y up.

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
    for item in scene.objects:
        seen = item.evaluated_get(bpy.context.evaluated_depsgraph_get())
        corners = [item.matrix_world @ vertex.co for vertex in seen.to_mesh().vertices]
        x, y, z = item.matrix_world.translation
        low = [min(c.x for c in corners), min(c.z for c in corners), min(-c.y for c in corners)]
        found.setdefault(item.name, {}).update({name: [x, z, -y], name + "_low": low})
with open(places, "w") as file:
    json.dump(found, file)
