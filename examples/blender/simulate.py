"""Simulates a scene inside Blender: a mesh object for each piece, with key frames of its motion.

    blender --background --python examples/blender/simulate.py -- scenes/brick_wall.json 60 wall.blend

The Python package is found as docs/python.md says. Blender has z up, Griffith y.
"""
import sys

import bpy
import griffith
import numpy
from mathutils import Matrix, Quaternion, Vector

Z_UP = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0))).to_4x4()


def pose_of(frame, body):
    """Returns the pose of a piece as Blender's matrix."""
    x, y, z, w = frame.body_orientations[body]
    return Z_UP @ Matrix.Translation(Vector(frame.body_positions[body])) @ Quaternion((w, x, y, z)).to_matrix().to_4x4()


def mesh_of(frame, body):
    """Returns the visible mesh of a piece in the piece's own frame; crack faces have the second material."""
    first, count = frame.surface_first_vertices[body], frame.surface_vertex_counts[body]
    start, triangles = frame.surface_first_triangles[body], frame.surface_triangle_counts[body]
    mesh = bpy.data.meshes.new(f"piece {body}")
    mesh.from_pydata(
        frame.surface_positions[first : first + count].tolist(),
        [],
        frame.surface_triangles[start : start + triangles].tolist(),
    )
    mesh.materials.append(material("outside", (0.55, 0.2, 0.12, 1)))
    mesh.materials.append(material("inside", (0.75, 0.5, 0.35, 1)))
    mesh.polygons.foreach_set("material_index", frame.surface_is_crack[start : start + triangles].astype(numpy.int32))
    return mesh


def material(name, color):
    """Returns the material of that name, creating it if necessary."""
    found = bpy.data.materials.get(name) or bpy.data.materials.new(name)
    found.diffuse_color = color
    return found


def key(object_, frame_number):
    """Adds key frames of the pose of an object."""
    object_.keyframe_insert("location", frame=frame_number)
    object_.keyframe_insert("rotation_quaternion", frame=frame_number)


def show_from(object_, frame_number):
    """Hides an object before a frame."""
    for hidden, at in ((True, 0), (False, frame_number)):
        object_.hide_viewport = object_.hide_render = hidden
        object_.keyframe_insert("hide_viewport", frame=at)
        object_.keyframe_insert("hide_render", frame=at)


def simulate(scene, steps):
    """Adds the pieces of a run to the open file. A piece that cracks is followed by new objects."""
    world = griffith.World(scene)
    shown, known = {}, {}
    for step in range(steps + 1):
        if step:
            world.step()
        frame = world.frame
        counts = frame.surface_vertex_counts
        for body in range(len(counts)):
            if counts[body] == 0:
                continue
            if known.get(body) != counts[body]:  # the surface changes with cracks; small deformations before are omitted
                if body in shown:
                    last = shown[body]
                    last.hide_viewport = last.hide_render = True
                    last.keyframe_insert("hide_viewport", frame=step)
                    last.keyframe_insert("hide_render", frame=step)
                made = bpy.data.objects.new(f"piece {body}", mesh_of(frame, body))
                made.rotation_mode = "QUATERNION"
                bpy.context.collection.objects.link(made)
                show_from(made, step)
                shown[body], known[body] = made, int(counts[body])
            shown[body].matrix_world = pose_of(frame, body)
            key(shown[body], step)
    bpy.context.scene.frame_end = steps
    return len(frame.body_masses)


def main():
    scene, steps, output = sys.argv[sys.argv.index("--") + 1 :]
    for object_ in list(bpy.data.objects):
        bpy.data.objects.remove(object_)
    pieces = simulate(scene, int(steps))
    bpy.ops.wm.save_as_mainfile(filepath=output)
    print(f"{pieces} pieces, {len(bpy.data.objects)} objects")


if __name__ == "__main__":
    main()
