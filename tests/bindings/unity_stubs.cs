// Stand-ins for what the Unity component uses of UnityEngine, so that it is compiled here. Nothing of them is run.
using System;
using System.Collections.Generic;

namespace UnityEngine {

public sealed class TooltipAttribute : Attribute {
  public TooltipAttribute(string text) {}
}

public class Object {
  public static void Destroy(Object target) {}
}

public class Component : Object {
  public GameObject gameObject { get { return null; } }
  public Transform transform { get { return null; } }
}

public class MonoBehaviour : Component {}

public sealed class GameObject : Object {
  public GameObject(string name) {}
  public Transform transform { get { return null; } }
  public T AddComponent<T>() where T : Component { return null; }
}

public sealed class Transform : Component {
  public Vector3 localPosition { get; set; }
  public Quaternion localRotation { get; set; }
  public void SetParent(Transform parent, bool worldPositionStays) {}
}

public sealed class MeshFilter : Component {
  public Mesh sharedMesh { get; set; }
}

public sealed class MeshRenderer : Component {
  public Material[] sharedMaterials { get; set; }
}

public sealed class Material : Object {}

public sealed class Mesh : Object {
  public Vector3[] vertices { get; set; }
  public Vector3[] normals { get; set; }
  public Rendering.IndexFormat indexFormat { get; set; }
  public int subMeshCount { get; set; }
  public void Clear() {}
  public void SetTriangles(List<int> triangles, int submesh) {}
}

namespace Rendering {
public enum IndexFormat { UInt16, UInt32 }
}

public struct Vector3 {
  public float x, y, z;
  public Vector3(float x, float y, float z) {
    this.x = x;
    this.y = y;
    this.z = z;
  }
}

public struct Quaternion {
  public float x, y, z, w;
  public Quaternion(float x, float y, float z, float w) {
    this.x = x;
    this.y = y;
    this.z = z;
    this.w = w;
  }
}

public static class Time {
  public static float fixedDeltaTime { get { return 0.02f; } }
}

}  // namespace UnityEngine
