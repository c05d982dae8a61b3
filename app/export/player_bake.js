'use strict';

/** The numbers of the page: a header in JSON, then arrays of floats and of indices in the order in which it counts them. */
function readBake() {
  const bake = JSON.parse(document.getElementById('bake').textContent);
  const floats = reader(new Float32Array(bytesOf('floats')));
  const indices = reader(new Uint32Array(bytesOf('indices')));
  for (const thing of bake.things) {
    thing.points = floats(3 * thing.pointCount);
    thing.normals = floats(3 * thing.pointCount);
    thing.poses = floats(7 * thing.poseCount);
    thing.deformed = floats(3 * thing.pointCount * thing.deformedCount);
    thing.triangles = thing.triangleCounts.map(count => indices(3 * count));
  }
  return bake;
}

function bytesOf(id) {
  const text = atob(document.getElementById(id).textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

/** Hands out the numbers of an array, one stretch after the other. */
function reader(array) {
  let at = 0;
  return count => array.subarray(at, at += count);
}

/** Where a thing is at a frame, which may lie between two: [x, y, z, qx, qy, qz, qw]; null before it is there. */
function poseAt(thing, frame) {
  const at = frame - thing.firstFrame;
  if (at < 0) return null;
  const last = thing.poseCount - 1, i = Math.min(Math.floor(at), last), j = Math.min(i + 1, last);
  return mixedPose(thing.poses.subarray(7 * i, 7 * i + 7), thing.poses.subarray(7 * j, 7 * j + 7), at - i);
}

/** Rotations are mixed along the shorter arc; frames are so close that no slerp is needed. */
function mixedPose(a, b, t) {
  let dot = 0, length = 0;
  for (let i = 3; i < 7; ++i) dot += a[i] * b[i];
  const pose = Array.from(a, (value, i) => value + t * ((i > 2 && dot < 0 ? -b[i] : b[i]) - value));
  for (let i = 3; i < 7; ++i) length += pose[i] * pose[i];
  for (let i = 3; i < 7; ++i) pose[i] /= Math.sqrt(length);
  return pose;
}

/** The points of a thing that deforms, in its own frame, at a frame. */
function deformedAt(thing, frame) {
  const count = 3 * thing.pointCount, last = thing.deformedCount - 1;
  const at = Math.min(Math.max(frame - thing.firstFrame, 0), last), i = Math.floor(at), j = Math.min(i + 1, last);
  const a = thing.deformed.subarray(i * count, (i + 1) * count), b = thing.deformed.subarray(j * count, (j + 1) * count);
  return a.map((value, k) => value + (at - i) * (b[k] - value));
}

function rotated(pose, v) {
  const [, , , x, y, z, w] = pose;
  const tx = 2 * (y * v[2] - z * v[1]), ty = 2 * (z * v[0] - x * v[2]), tz = 2 * (x * v[1] - y * v[0]);
  return [v[0] + w * tx + y * tz - z * ty, v[1] + w * ty + z * tx - x * tz, v[2] + w * tz + x * ty - y * tx];
}

/** The box round all things but those that fly, at a frame: [low, high]. */
function boundsAt(bake, frame) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const thing of bake.things) {
    const pose = thing.body === null ? null : poseAt(thing, frame);
    if (!pose) continue;
    for (let i = 0; i < thing.points.length; i += 3) {
      const point = rotated(pose, thing.points.subarray(i, i + 3));
      for (let k = 0; k < 3; ++k) {
        low[k] = Math.min(low[k], point[k] + pose[k]);
        high[k] = Math.max(high[k], point[k] + pose[k]);
      }
    }
  }
  return low[0] <= high[0] ? [low, high] : [[-1, -1, -1], [1, 1, 1]];
}

/** How many pieces broke off up to each frame since the one before. */
function breaksPerFrame(bake) {
  const breaks = new Array(bake.times.length).fill(0);
  for (const thing of bake.things) {
    if (thing.breakTime === null) continue;
    const frame = bake.times.findIndex(time => time >= thing.breakTime - 1e-9);
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
