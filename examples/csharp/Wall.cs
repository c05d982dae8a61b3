// A wall, a ball shot at it, and the resulting pieces.
using System;
using Griffith;

static class Wall {
  static int Main(string[] arguments) {
    try {
      using (Scene scene = Scene.Read(arguments.Length > 0 ? arguments[0] : "scenes/wall_small.json"))
      using (var world = new World(scene)) {
        world.Step(60);
        View masses = world.Array(ArrayId.BodyMasses);
        View utilization = world.Array(ArrayId.NodeUtilization);
        double highest = 0;
        for (int i = 0; i < utilization.Count; ++i) highest = Math.Max(highest, utilization.Number(i));
        for (int i = 0; i < masses.Count; ++i) Console.WriteLine("{0,10:F1} kg", masses.Number(i));
        Console.WriteLine("{0} pieces, highest utilization {1:F3}, state {2:x16}", masses.Count, highest,
                          world.StateHash);
      }
      return 0;
    } catch (GriffithException problem) {
      Console.Error.WriteLine(problem.Message);
      return 1;
    }
  }
}
