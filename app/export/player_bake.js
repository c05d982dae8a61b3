'use strict';

/** The numbers of the page: a header in JSON, then arrays of floats and of indices in the order of the header. */
function readBake() {
  const bake = JSON.parse(document.getElementById('bake').textContent);
  const floats = reader(new Float32Array(bytesOf('floats')));
  const indices = reader(new Uint32Array(bytesOf('indices')));
  for (const object of bake.objects) {
    object.points = floats(3 * object.pointCount);
    object.normals = floats(3 * object.pointCount);
    object.poses = floats(7 * object.poseCount);
    object.deformed = floats(3 * object.pointCount * object.deformedCount);
    object.triangles = object.triangleCounts.map(count => indices(3 * count));
  }
  return bake;
}

function bytesOf(id) {
  const text = atob(document.getElementById(id).textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

/** Returns consecutive parts of an array. */
function reader(array) {
  let at = 0;
  return count => array.subarray(at, at += count);
}

/** Pose of an object at a frame, which may be fractional: [x, y, z, qx, qy, qz, qw]; null before it exists. */
function poseAt(object, frame) {
  const at = frame - object.firstFrame;
  if (at < 0) return null;
  const last = object.poseCount - 1, i = Math.min(Math.floor(at), last), j = Math.min(i + 1, last);
  return mixedPose(object.poses.subarray(7 * i, 7 * i + 7), object.poses.subarray(7 * j, 7 * j + 7), at - i);
}

/** Rotations are interpolated along the shorter arc; frames are so close that no slerp is needed. */
function mixedPose(a, b, t) {
  let dot = 0, length = 0;
  for (let i = 3; i < 7; ++i) dot += a[i] * b[i];
  const pose = Array.from(a, (value, i) => value + t * ((i > 2 && dot < 0 ? -b[i] : b[i]) - value));
  for (let i = 3; i < 7; ++i) length += pose[i] * pose[i];
  for (let i = 3; i < 7; ++i) pose[i] /= Math.sqrt(length);
  return pose;
}

/** Points of a deforming object at a frame, in its own coordinates. */
function deformedAt(object, frame) {
  const count = 3 * object.pointCount, last = object.deformedCount - 1;
  const at = Math.min(Math.max(frame - object.firstFrame, 0), last), i = Math.floor(at), j = Math.min(i + 1, last);
  const a = object.deformed.subarray(i * count, (i + 1) * count), b = object.deformed.subarray(j * count, (j + 1) * count);
  return a.map((value, k) => value + (at - i) * (b[k] - value));
}

function rotated(pose, v) {
  const [, , , x, y, z, w] = pose;
  const tx = 2 * (y * v[2] - z * v[1]), ty = 2 * (z * v[0] - x * v[2]), tz = 2 * (x * v[1] - y * v[0]);
  return [v[0] + w * tx + y * tz - z * ty, v[1] + w * ty + z * tx - x * tz, v[2] + w * tz + x * ty - y * tx];
}

/** Bounding box of all objects except projectiles at a frame: [low, high]. */
function boundsAt(bake, frame) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const object of bake.objects) {
    const pose = object.body === null ? null : poseAt(object, frame);
    if (!pose) continue;
    for (let i = 0; i < object.points.length; i += 3) {
      const point = rotated(pose, object.points.subarray(i, i + 3));
      for (let k = 0; k < 3; ++k) {
        low[k] = Math.min(low[k], point[k] + pose[k]);
        high[k] = Math.max(high[k], point[k] + pose[k]);
      }
    }
  }
  return low[0] <= high[0] ? [low, high] : [[-1, -1, -1], [1, 1, 1]];
}

/** Number of pieces that broke off between each frame and the one before. */
function breaksPerFrame(bake) {
  const breaks = new Array(bake.times.length).fill(0);
  for (const object of bake.objects) {
    if (object.breakTime === null) continue;
    const frame = bake.times.findIndex(time => time >= object.breakTime - 1e-9);
    if (frame > 0) ++breaks[frame];
  }
  return breaks;
}

/** "12.3 kg": a number with an SI prefix. */
function quantity(value, unit) {
  const prefixes = [[1e9, 'G'], [1e6, 'M'], [1e3, 'k'], [1, ''], [1e-3, 'm'], [1e-6, 'µ'], [1e-9, 'n']];
  if (unit === 'kg') return value >= 1 || value === 0 ? `${+value.toPrecision(3)} kg` : quantity(1e3 * value, 'g');
  if (unit === 'm²') return value >= 0.1 || value === 0 ? `${+value.toPrecision(3)} m²` : `${+(1e4 * value).toPrecision(3)} cm²`;
  const [factor, prefix] = prefixes.find(([factor]) => Math.abs(value) >= factor) || (value === 0 ? [1, ''] : prefixes.at(-1));
  return `${+(value / factor).toPrecision(3)} ${prefix}${unit}`;
}
