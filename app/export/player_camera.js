'use strict';

/** Orbit camera; angles in radians. */
class Camera {
  constructor() {
    this.target = [0, 0, 0];
    this.distance = 5;
    this.yaw = 0.6;
    this.pitch = 0.25;
    this.fov = 40 * Math.PI / 180;
  }

  /** Shows all of a box. */
  frame([low, high], aspect) {
    this.target = low.map((value, k) => (value + high[k]) / 2);
    const radius = Math.hypot(...high.map((value, k) => value - low[k])) / 2 || 1;
    this.distance = 1.15 * radius / Math.sin(Math.atan(Math.tan(this.fov / 2) * Math.min(aspect, 1)));
  }

  turn(right, down) {
    this.yaw -= right;
    this.pitch = Math.min(Math.max(this.pitch + down, -1.55), 1.55);
  }

  /** By fractions of the view's height. */
  move(right, down) {
    const size = 2 * this.distance * Math.tan(this.fov / 2), [x, y] = this.axes();
    for (let k = 0; k < 3; ++k) this.target[k] += size * (down * y[k] - right * x[k]);
  }

  zoom(factor) { this.distance = Math.min(Math.max(this.distance * factor, 1e-4), 1e6); }

  /** Right, up and toward the eye. */
  axes() {
    const [sy, cy, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    return [[cy, 0, -sy], [-sy * sp, cp, -cy * sp], [sy * cp, sp, cy * cp]];
  }

  eye() {
    const back = this.axes()[2];
    return this.target.map((value, k) => value + this.distance * back[k]);
  }

  /** From the world to clip space, by columns. */
  matrix(aspect) {
    const [x, y, z] = this.axes(), eye = this.eye(), dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const near = this.distance / 100, far = this.distance * 100;
    const f = 1 / Math.tan(this.fov / 2), a = (far + near) / (near - far), b = 2 * far * near / (near - far);
    const rows = [x.map(v => v * f / aspect), y.map(v => v * f), z.map(v => v * a), z.map(v => -v)];
    const ends = [-dot(x, eye) * f / aspect, -dot(y, eye) * f, -dot(z, eye) * a + b, dot(z, eye)];
    return new Float32Array([0, 1, 2].flatMap(k => rows.map(row => row[k])).concat(ends));
  }
}
