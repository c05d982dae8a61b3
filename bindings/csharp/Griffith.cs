// Griffith from C#: brittle fracture in real time, over the C interface of include/griffith/griffith.h.
//
//     using (var scene = Scene.Read("scenes/wall_small.json"))
//     using (var world = new World(scene)) {
//       world.Step(60);
//       View utilization = world.Array(ArrayId.NodeUtilization);
//     }
//
// Nothing is allocated by a step, an array or a value. Compile with /unsafe.
using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Griffith {

/// <summary>Result of a call of the library: griffith_status.</summary>
public enum Status { Ok = 0, InvalidArgument = 1, InputError = 2, Cancelled = 3, OutOfMemory = 4, InternalError = 5 }

/// <summary>A failed call of the library.</summary>
public sealed class GriffithException : Exception {
  public Status Status { get; }
  /// <summary>Place: a file, file:line, file#/json/pointer, or the argument.</summary>
  public string Where { get; }
  public string Problem { get; }
  /// <summary>Correction; may be empty.</summary>
  public string Remedy { get; }

  public GriffithException(Status status, string where, string problem, string remedy)
      : base(where + ": " + problem + (remedy.Length > 0 ? " (" + remedy + ")" : "")) {
    Status = status;
    Where = where;
    Problem = problem;
    Remedy = remedy;
  }
}

/// <summary>Arrays of a frame: griffith_array_id, with types, shapes and units.</summary>
public enum ArrayId {
  NodePositions = 0, NodeRestPositions, NodeVelocities, NodeMasses, NodeUtilization, NodeSeparationTensors,
  NodeSeparationNormals, NodeSeparationStress, NodeResistance, NodeReactions, NodeHasSupport, NodeAtCrackFront,
  TetNodes, TetNeighbors, TetBodies, TetStress,
  BodyPositions, BodyOrientations, BodyVelocities, BodyAngularVelocities, BodyMasses, BodyParents, BodySceneBodies,
  BodyIsRigid, BodyIsAsleep, BodyIsSupported,
  CrackSteps, CrackTimes, CrackNodes, CrackBodies, CrackPositions, CrackNormals, CrackLoads, CrackResistance,
  ContactBodiesA, ContactBodiesB, ContactPositions, ContactNormals, ContactImpulses,
  ProjectilePositions, ProjectileVelocities, ProjectileRotations, ProjectileRadii, ProjectileMasses,
  SurfacePositions, SurfaceNormals, SurfaceTriangles, SurfaceIsCrack, SurfaceFirstVertices, SurfaceVertexCounts,
  SurfaceFirstTriangles, SurfaceTriangleCounts, SurfaceVersions
}

/// <summary>Three numbers in double precision.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Double3 { public double X, Y, Z; }
/// <summary>A unit quaternion in double precision.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Quaternion4 { public double X, Y, Z, W; }
/// <summary>A symmetric tensor, row by row.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Tensor3 { public double XX, XY, XZ, YX, YY, YZ, ZX, ZY, ZZ; }
/// <summary>Three numbers in single precision.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Float3 { public float X, Y, Z; }
/// <summary>Three or four indices.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Int3 { public int A, B, C; }
[StructLayout(LayoutKind.Sequential)]
public struct Int4 { public int A, B, C, D; }

/// <summary>Types of numbers in arrays: griffith_type.</summary>
public enum NumberType { Float64 = 0, Float32 = 1, Int64 = 2, Int32 = 3, UInt8 = 4 }

/// <summary>A view of the library's own memory, valid until the next call that changes the world.</summary>
public unsafe struct View {
  /// <summary>The first entry; null if Count is 0.</summary>
  public readonly byte* Data;
  public readonly int Count;
  /// <summary>Bytes from one entry to the next.</summary>
  public readonly int Stride;
  public readonly NumberType Type;
  /// <summary>Numbers of an entry: 1, 3 of a vector, 9 of a tensor.</summary>
  public readonly int Components;

  internal View(byte* data, int count, int stride, NumberType type, int components) {
    Data = data;
    Count = count;
    Stride = stride;
    Type = type;
    Components = components;
  }

  /// <summary>Bytes of an entry.</summary>
  public int EntrySize {
    get {
      int size = Type == NumberType.UInt8 ? 1 : Type == NumberType.Float32 || Type == NumberType.Int32 ? 4 : 8;
      return size * Components;
    }
  }

  /// <summary>True if entries are contiguous, as in NativeArray.</summary>
  public bool IsContiguous { get { return Stride == EntrySize; } }

  public double Number(int index) { return *(double*)At(index, NumberType.Float64, 1); }
  public Double3 Vector(int index) { return *(Double3*)At(index, NumberType.Float64, 3); }
  public Quaternion4 Quaternion(int index) { return *(Quaternion4*)At(index, NumberType.Float64, 4); }
  public Tensor3 Tensor(int index) { return *(Tensor3*)At(index, NumberType.Float64, 9); }
  public Float3 Single3(int index) { return *(Float3*)At(index, NumberType.Float32, 3); }
  public int Index(int index) { return *(int*)At(index, NumberType.Int32, 1); }
  public Int3 Triangle(int index) { return *(Int3*)At(index, NumberType.Int32, 3); }
  public Int4 Tetrahedron(int index) { return *(Int4*)At(index, NumberType.Int32, 4); }
  public long Long(int index) { return *(long*)At(index, NumberType.Int64, 1); }
  public bool Flag(int index) { return *At(index, NumberType.UInt8, 1) != 0; }

  byte* At(int index, NumberType type, int components) {
    if ((uint)index >= (uint)Count) throw new IndexOutOfRangeException();
    if (Type != type || Components != components)
      throw new InvalidOperationException("the array has entries of " + Components + " " + Type);
    return Data + (long)index * Stride;
  }
}

/// <summary>A description of bodies, materials, supports, loads and shots.</summary>
public sealed unsafe class Scene : IDisposable {
  internal IntPtr Handle;

  Scene(IntPtr handle) { Handle = handle; }

  public static Scene Read(string path) {
    IntPtr handle;
    Native.Check(Native.griffith_scene_read(Native.Utf8(path), out handle, Native.ClearError()));
    return new Scene(handle);
  }

  /// <summary>Reads a scene from JSON text; relative paths in it start at `folder`, null: the current one.</summary>
  public static Scene Parse(string json, string folder = null) {
    IntPtr handle;
    Native.Check(Native.griffith_scene_parse(Native.Utf8(json), Native.Utf8(folder), out handle, Native.ClearError()));
    return new Scene(handle);
  }

  /// <summary>Sets the field at a JSON pointer to a value in JSON.</summary>
  public void Set(string pointer, string json) {
    Native.Check(Native.griffith_scene_set(Handle, Native.Utf8(pointer), Native.Utf8(json), Native.ClearError()));
  }

  /// <summary>Returns the value at a JSON pointer as JSON text; "" is the whole scene.</summary>
  public string Get(string pointer) {
    IntPtr text;
    Native.Check(Native.griffith_scene_get(Handle, Native.Utf8(pointer), out text, Native.ClearError()));
    try {
      return Native.Text((byte*)text, int.MaxValue);
    } finally {
      Native.griffith_string_free(text);
    }
  }

  /// <summary>Adds tetrahedra for bodies whose shape is {"mesh": {"path": name}}.</summary>
  public void SetMesh(string name, double[] points, int[] tets) {
    Native.Check(Native.griffith_scene_set_mesh(Handle, Native.Utf8(name), points, points.Length / 3, tets,
                                                tets.Length / 4, Native.ClearError()));
  }

  public void Dispose() {
    Native.griffith_scene_destroy(Handle);
    Handle = IntPtr.Zero;
    GC.SuppressFinalize(this);
  }

  ~Scene() { Native.griffith_scene_destroy(Handle); }
}

/// <summary>A simulation of a scene. Used by one thread at a time.</summary>
public sealed unsafe class World : IDisposable {
  IntPtr handle_;

  public World(Scene scene) {
    Native.Check(Native.griffith_world_create(scene.Handle, IntPtr.Zero, out handle_, Native.ClearError()));
  }

  World(IntPtr handle) { handle_ = handle; }

  /// <summary>Advances by time steps of the scene. Earlier views become invalid.</summary>
  public void Step(int count = 1) { Native.Check(Native.griffith_world_step(handle_, count, Native.ClearError())); }

  /// <summary>Returns a copy that continues identically.</summary>
  public World Copy() {
    IntPtr copy;
    Native.Check(Native.griffith_world_copy(handle_, out copy, Native.ClearError()));
    return new World(copy);
  }

  public void Restore(World copy) {
    Native.Check(Native.griffith_world_restore(handle_, copy.handle_, Native.ClearError()));
  }

  /// <summary>Fires a sphere now [m, m/s, kg].</summary>
  public void Fire(Double3 position, Double3 direction, double speed, double mass, double radius) {
    var shot = new Native.Shot { Position = position, Direction = direction, Speed = speed, Mass = mass,
                                 Radius = radius };
    Native.Check(Native.griffith_world_fire(handle_, ref shot, Native.ClearError()));
  }

  /// <summary>Pushes the material at a position [m], or the nearest point of the surface, with an impulse [N·s].</summary>
  public void Push(Double3 position, Double3 impulse) {
    Native.Check(Native.griffith_world_push(handle_, ref position, ref impulse, Native.ClearError()));
  }

  /// <summary>Grabs the material at a position [m], or the nearest point of the surface: a spring pulls it to the
  /// target [m]. Frequency [Hz]; strength: greatest force, in weights of the piece.</summary>
  public void Grab(Double3 position, Double3 target, double frequency = 3, double dampingRatio = 0.7,
                   double strength = 10) {
    var spring = new Native.Spring { Frequency = frequency, DampingRatio = dampingRatio, Strength = strength };
    Native.Check(Native.griffith_world_grab(handle_, ref position, ref target, ref spring, Native.ClearError()));
  }

  /// <summary>Moves the target of the grab [m].</summary>
  public void MoveGrab(Double3 target) {
    Native.Check(Native.griffith_world_move_grab(handle_, ref target, Native.ClearError()));
  }

  /// <summary>Ends the grab, if there is one.</summary>
  public void Release() { Native.Check(Native.griffith_world_release(handle_, Native.ClearError())); }

  /// <summary>Changes a field of the material of a body of the scene, as JSON text.</summary>
  public void SetMaterial(int sceneBody, string field, string json) {
    Native.Check(Native.griffith_world_set_material(handle_, sceneBody, Native.Utf8(field), Native.Utf8(json),
                                                    Native.ClearError()));
  }

  public void StartRecording() { Native.Check(Native.griffith_world_start_recording(handle_, Native.ClearError())); }

  public void SaveRecording(string path) {
    Native.Check(Native.griffith_world_save_recording(handle_, Native.Utf8(path), Native.ClearError()));
  }

  /// <summary>Hash of the state, as in the command line.</summary>
  public ulong StateHash { get { return Native.griffith_world_state_hash(handle_); } }

  /// <summary>Returns a number of the frame by its name: "kinetic_energy".</summary>
  public double Value(string name) {
    double value;
    Native.Check(Native.griffith_world_value(handle_, Native.Utf8(name), out value, Native.ClearError()));
    return value;
  }

  /// <summary>Returns a view of an array.</summary>
  public View Array(ArrayId array) {
    Native.ArrayView view;
    Native.Check(Native.griffith_world_array(handle_, (int)array, out view, Native.ClearError()));
    return new View((byte*)view.Data, checked((int)view.Count), checked((int)view.Stride), (NumberType)view.Type,
                    view.Rows * view.Columns);
  }

  /// <summary>Computes a quantity per node or tetrahedron: "von_mises". Valid until the next one.</summary>
  public View Quantity(string name) {
    Native.ArrayView view;
    Native.Check(Native.griffith_world_quantity(handle_, Native.Utf8(name), out view, Native.ClearError()));
    return new View((byte*)view.Data, checked((int)view.Count), checked((int)view.Stride), (NumberType)view.Type,
                    view.Rows * view.Columns);
  }

  /// <summary>Updates the surface arrays.</summary>
  public void UpdateSurfaces() { Native.Check(Native.griffith_world_update_surfaces(handle_, Native.ClearError())); }

  public void Dispose() {
    Native.griffith_world_destroy(handle_);
    handle_ = IntPtr.Zero;
    GC.SuppressFinalize(this);
  }

  ~World() { Native.griffith_world_destroy(handle_); }
}

/// <summary>Functions of the library.</summary>
static unsafe class Native {
  const string Library = "griffith";  // libgriffith.so

  [StructLayout(LayoutKind.Sequential)]
  internal struct ArrayView {
    public IntPtr Data;
    public long Count, Stride;
    public int Type, Dimensions, Rows, Columns;
  }

  [StructLayout(LayoutKind.Sequential)]
  internal struct Shot {
    public Double3 Position, Direction;
    public double Speed, Mass, Radius;
  }

  [StructLayout(LayoutKind.Sequential)]
  internal struct Spring {
    public double Frequency, DampingRatio, Strength;
  }

  [StructLayout(LayoutKind.Sequential)]
  internal struct Error {
    public int Status;
    public fixed byte Where[512];
    public fixed byte Problem[1024];
    public fixed byte Remedy[512];
  }

  // One per thread, made once: a call allocates nothing.
  [ThreadStatic] static IntPtr error_;

  internal static IntPtr ClearError() {
    if (error_ == IntPtr.Zero) error_ = Marshal.AllocHGlobal(sizeof(Error));
    return error_;
  }

  internal static void Check(int status) {
    if (status == 0) return;
    var error = (Error*)error_;
    throw new GriffithException((Status)status, Text(error->Where, 512), Text(error->Problem, 1024),
                                Text(error->Remedy, 512));
  }

  internal static string Text(byte* text, int limit) {
    int length = 0;
    while (length < limit && text[length] != 0) ++length;
    return Encoding.UTF8.GetString(text, length);
  }

  internal static byte[] Utf8(string text) { return text == null ? null : Encoding.UTF8.GetBytes(text + '\0'); }

  [DllImport(Library)] internal static extern int griffith_scene_read(byte[] path, out IntPtr scene, IntPtr error);
  [DllImport(Library)] internal static extern int griffith_scene_parse(byte[] json, byte[] folder, out IntPtr scene,
                                                                       IntPtr error);
  [DllImport(Library)] internal static extern void griffith_scene_destroy(IntPtr scene);
  [DllImport(Library)] internal static extern int griffith_scene_set(IntPtr scene, byte[] pointer, byte[] json,
                                                                     IntPtr error);
  [DllImport(Library)] internal static extern int griffith_scene_get(IntPtr scene, byte[] pointer, out IntPtr json,
                                                                     IntPtr error);
  [DllImport(Library)] internal static extern int griffith_scene_set_mesh(IntPtr scene, byte[] name, double[] points,
                                                                          long pointCount, int[] tets, long tetCount,
                                                                          IntPtr error);
  [DllImport(Library)] internal static extern void griffith_string_free(IntPtr text);
  [DllImport(Library)] internal static extern int griffith_world_create(IntPtr scene, IntPtr monitor, out IntPtr world,
                                                                        IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_copy(IntPtr world, out IntPtr copy, IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_restore(IntPtr world, IntPtr copy, IntPtr error);
  [DllImport(Library)] internal static extern void griffith_world_destroy(IntPtr world);
  [DllImport(Library)] internal static extern int griffith_world_step(IntPtr world, int count, IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_fire(IntPtr world, ref Shot shot, IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_push(IntPtr world, ref Double3 position,
                                                                      ref Double3 impulse, IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_grab(IntPtr world, ref Double3 position,
                                                                      ref Double3 target, ref Spring spring,
                                                                      IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_move_grab(IntPtr world, ref Double3 target,
                                                                           IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_release(IntPtr world, IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_set_material(IntPtr world, int sceneBody,
                                                                              byte[] field, byte[] json, IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_start_recording(IntPtr world, IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_save_recording(IntPtr world, byte[] path,
                                                                                IntPtr error);
  [DllImport(Library)] internal static extern ulong griffith_world_state_hash(IntPtr world);
  [DllImport(Library)] internal static extern int griffith_world_value(IntPtr world, byte[] name, out double value,
                                                                       IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_array(IntPtr world, int array, out ArrayView view,
                                                                       IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_quantity(IntPtr world, byte[] name,
                                                                          out ArrayView view, IntPtr error);
  [DllImport(Library)] internal static extern int griffith_world_update_surfaces(IntPtr world, IntPtr error);
}

}  // namespace Griffith
