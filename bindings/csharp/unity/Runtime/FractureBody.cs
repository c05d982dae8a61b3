// A scene of Griffith as Unity objects: one mesh for each piece, steps in FixedUpdate. Copy bindings/csharp/Griffith.cs next to this
// file, and libgriffith.so into Plugins.
using System.Collections.Generic;
using UnityEngine;

namespace Griffith {

/// <summary>Runs a scene file and draws its pieces. Griffith is right-handed with y up, Unity left-handed: z changes
/// its sign.</summary>
public sealed class FractureBody : MonoBehaviour {
  [Tooltip("Scene file, as scenes/README.md describes it")]
  public string ScenePath;
  [Tooltip("Of the outside of pieces")]
  public Material Outside;
  [Tooltip("Of crack faces")]
  public Material Inside;

  /// <summary>A piece with its game object.</summary>
  sealed class Piece {
    public Transform Place;
    public Mesh Mesh;
    public int Version;
  }

  World world_;
  readonly List<Piece> pieces_ = new List<Piece>();
  double time_;

  void OnEnable() {
    using (Scene scene = Scene.Read(ScenePath)) world_ = new World(scene);
    time_ = 0;
    Draw();
  }

  void OnDisable() {
    foreach (Piece piece in pieces_) {
      Destroy(piece.Mesh);
      Destroy(piece.Place.gameObject);
    }
    pieces_.Clear();
    if (world_ != null) world_.Dispose();
    world_ = null;
  }

  /// <summary>Fires a sphere from a point of Unity's world [m, m/s, kg].</summary>
  public void Fire(Vector3 position, Vector3 direction, float speed, float mass, float radius) {
    world_.Fire(ToGriffith(position), ToGriffith(direction), speed, mass, radius);
  }

  void FixedUpdate() {
    time_ += Time.fixedDeltaTime;
    double step = world_.Value("time_step");
    int count = 0;
    for (; time_ >= step; time_ -= step) ++count;
    if (count > 0) world_.Step(count);
  }

  void Update() { Draw(); }

  void Draw() {
    world_.UpdateSurfaces();
    View versions = world_.Array(ArrayId.SurfaceVersions);
    View positions = world_.Array(ArrayId.BodyPositions), turns = world_.Array(ArrayId.BodyOrientations);
    while (pieces_.Count < versions.Count) pieces_.Add(MakePiece(pieces_.Count));
    for (int i = 0; i < versions.Count; ++i) {
      Piece piece = pieces_[i];
      if (piece.Version != versions.Index(i)) Upload(piece, i, versions.Index(i));
      piece.Place.localPosition = ToUnity(positions.Vector(i));
      Quaternion4 turn = turns.Quaternion(i);
      piece.Place.localRotation = new Quaternion(-(float)turn.X, -(float)turn.Y, (float)turn.Z, (float)turn.W);
    }
  }

  Piece MakePiece(int index) {
    var drawn = new GameObject("piece " + index);
    drawn.transform.SetParent(transform, false);
    var piece = new Piece { Place = drawn.transform, Mesh = new Mesh() };
    drawn.AddComponent<MeshFilter>().sharedMesh = piece.Mesh;
    drawn.AddComponent<MeshRenderer>().sharedMaterials = new[] { Outside, Inside };
    return piece;
  }

  void Upload(Piece piece, int body, int version) {
    View corners = world_.Array(ArrayId.SurfacePositions), normals = world_.Array(ArrayId.SurfaceNormals);
    View triangles = world_.Array(ArrayId.SurfaceTriangles), isCrack = world_.Array(ArrayId.SurfaceIsCrack);
    int firstVertex = world_.Array(ArrayId.SurfaceFirstVertices).Index(body);
    int vertexCount = world_.Array(ArrayId.SurfaceVertexCounts).Index(body);
    int firstTriangle = world_.Array(ArrayId.SurfaceFirstTriangles).Index(body);
    int triangleCount = world_.Array(ArrayId.SurfaceTriangleCounts).Index(body);
    var meshCorners = new Vector3[vertexCount];
    var meshNormals = new Vector3[vertexCount];
    for (int i = 0; i < vertexCount; ++i) {
      meshCorners[i] = ToUnity(corners.Single3(firstVertex + i));
      meshNormals[i] = ToUnity(normals.Single3(firstVertex + i));
    }
    List<int> outside = new List<int>(), inside = new List<int>();
    for (int i = firstTriangle; i < firstTriangle + triangleCount; ++i) {
      Int3 triangle = triangles.Triangle(i);  // the mirror image has the opposite orientation
      (isCrack.Flag(i) ? inside : outside).AddRange(new[] { triangle.A, triangle.C, triangle.B });
    }
    piece.Mesh.Clear();
    piece.Mesh.indexFormat = UnityEngine.Rendering.IndexFormat.UInt32;
    piece.Mesh.vertices = meshCorners;
    piece.Mesh.normals = meshNormals;
    piece.Mesh.subMeshCount = 2;
    piece.Mesh.SetTriangles(outside, 0);
    piece.Mesh.SetTriangles(inside, 1);
    piece.Version = version;
  }

  static Vector3 ToUnity(Double3 v) { return new Vector3((float)v.X, (float)v.Y, -(float)v.Z); }
  static Vector3 ToUnity(Float3 v) { return new Vector3(v.X, v.Y, -v.Z); }
  static Double3 ToGriffith(Vector3 v) { return new Double3 { X = v.x, Y = v.y, Z = -v.z }; }
}

}  // namespace Griffith
