'use strict';

/** Draws the objects of a bake at a frame. */
class View {
  constructor(canvas, bake) {
    this.canvas = canvas;
    this.bake = bake;
    const gl = this.gl = canvas.getContext('webgl2', {antialias: true, stencil: true, premultipliedAlpha: true});
    if (!gl) throw new Error('This browser has no WebGL 2, by which the run is drawn.');
    this.camera = new Camera();
    this.programs = {
      objects: program(gl, kObjectVertex, kObjectFragment),
      shadow: program(gl, kShadowVertex, kShadowFragment),
      pick: program(gl, kPickVertex, kPickFragment),
      ground: program(gl, kGroundVertex, kGroundFragment),
    };
    this.makeBuffers();
    this.poses = new Float32Array(8 * Math.max(bake.objects.length, 1));
    this.poseTexture = table(gl, this.poses);
    this.materialTexture = table(gl, Float32Array.from(bake.materials.flatMap(m => [...m.color, m.opacity, m.roughness, 0, 0, 0])));
    this.ground = Math.min(boundsAt(bake, 0)[0][1], boundsAt(bake, bake.times.length - 1)[0][1]);
    this.selected = -1;
    this.frameAll();
  }

  frameAll() { this.camera.frame(boundsAt(this.bake, 0), this.aspect()); }
  aspect() { return Math.max(this.canvas.clientWidth, 1) / Math.max(this.canvas.clientHeight, 1); }

  makeBuffers() {
    const gl = this.gl, {vertices, indices, opaque} = meshOf(this.bake);
    this.opaqueCount = opaque;
    this.clearCount = indices.length - opaque;
    this.vertices = vertices;
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    this.vertexBuffer = buffer(gl, gl.ARRAY_BUFFER, vertices);
    [['position', 3], ['normal', 3], ['style', 2]].reduce((at, [, size], i) => {
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, size, gl.FLOAT, false, 32, 4 * at);
      return at + size;
    }, 0);
    buffer(gl, gl.ELEMENT_ARRAY_BUFFER, indices);
    this.quad = gl.createVertexArray();
    gl.bindVertexArray(this.quad);
    buffer(gl, gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]));
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
  }

  /** Places all objects at a frame. Returns the number of visible ones. */
  place(frame) {
    const gl = this.gl, {objects} = this.bake;
    let there = 0;
    objects.forEach((object, i) => {
      const pose = poseAt(object, frame);
      this.poses.set(pose ? [pose[0], pose[1], pose[2], 1, ...pose.slice(3)] : [0, 0, 0, 0, 0, 0, 0, 1], 8 * i);
      there += pose ? 1 : 0;
    });
    gl.bindTexture(gl.TEXTURE_2D, this.poseTexture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 2, this.poses.length / 8, gl.RGBA, gl.FLOAT, this.poses);
    this.deform(frame);
    return there;
  }

  deform(frame) {
    const deforming = this.bake.objects.filter(object => object.deformedCount > 0);
    if (deforming.length === 0) return;
    for (const object of deforming) {
      const points = deformedAt(object, frame);
      for (const [vertex, point] of object.vertices) this.vertices.set(points.subarray(3 * point, 3 * point + 3), 8 * vertex);
    }
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.vertexBuffer);
    this.gl.bufferSubData(this.gl.ARRAY_BUFFER, 0, this.vertices);
  }

  /** Fits the canvas to its size on the screen. */
  fit() {
    const scale = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(scale * this.canvas.clientWidth));
    const height = Math.max(1, Math.round(scale * this.canvas.clientHeight));
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, {width, height});
  }

  draw() {
    const gl = this.gl;
    this.fit();
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);  // the page shows through
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.drawObjects(0, this.opaqueCount);
    gl.depthMask(false);
    this.drawGround();
    this.drawShadow();
    this.drawObjects(this.opaqueCount, this.clearCount);
    gl.depthMask(true);
  }

  use(name) {
    const gl = this.gl, found = this.programs[name];
    gl.useProgram(found.program);
    gl.uniformMatrix4fv(found.at('camera'), false, this.camera.matrix(this.aspect()));
    [['poses', this.poseTexture], ['materials', this.materialTexture]].forEach(([uniform, texture], unit) => {
      gl.uniform1i(found.at(uniform), unit);
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    gl.activeTexture(gl.TEXTURE0);
    gl.bindVertexArray(name === 'ground' ? this.quad : this.array);
    return found;
  }

  drawObjects(first, count) {
    const gl = this.gl, used = this.use('objects');
    gl.uniform1f(used.at('selected'), this.selected);
    gl.uniform3fv(used.at('eye'), this.camera.eye());
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
  }

  drawShadow() {
    const gl = this.gl, used = this.use('shadow');
    gl.uniform1f(used.at('ground'), this.ground);
    gl.enable(gl.STENCIL_TEST);  // overlapping shadows darken only once
    gl.stencilFunc(gl.EQUAL, 0, 255);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(-1, -1);
    for (const [first, count, darkness] of [[0, this.opaqueCount, 0.22], [this.opaqueCount, this.clearCount, 0.09]]) {
      gl.uniform1f(used.at('darkness'), darkness);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.disable(gl.STENCIL_TEST);
  }

  drawGround() {
    const gl = this.gl, used = this.use('ground'), size = 12 * this.camera.distance;
    const line = getComputedStyle(document.documentElement).getPropertyValue('--muted').trim();
    gl.uniform3f(used.at('middle'), this.camera.target[0], this.ground, this.camera.target[2]);
    gl.uniform3fv(used.at('line'), rgbOf(line));
    gl.uniform1f(used.at('size'), size);
    gl.uniform1f(used.at('cell'), 10 ** Math.floor(Math.log10(this.camera.distance / 2)));
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }

  /** Index of the object at a point of the canvas, in CSS pixels; -1: none. */
  pick(x, y) {
    const gl = this.gl, scale = this.canvas.width / Math.max(this.canvas.clientWidth, 1), pixel = new Uint8Array(4);
    this.fit();
    const target = new PickTarget(gl, this.canvas.width, this.canvas.height);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    this.use('pick');
    gl.drawElements(gl.TRIANGLES, this.opaqueCount + this.clearCount, gl.UNSIGNED_INT, 0);
    gl.readPixels(Math.floor(scale * x), this.canvas.height - 1 - Math.floor(scale * y), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    target.remove();
    return (pixel[0] | pixel[1] << 8 | pixel[2] << 16) - 1;
  }
}

/** An offscreen picture of object indices. */
class PickTarget {
  constructor(gl, width, height) {
    this.gl = gl;
    this.framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    this.buffers = [[gl.COLOR_ATTACHMENT0, gl.RGBA8], [gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24]].map(([place, format]) => {
      const made = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, made);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, made);
      return made;
    });
  }
  remove() {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
    this.gl.deleteFramebuffer(this.framebuffer);
    this.buffers.forEach(made => this.gl.deleteRenderbuffer(made));
  }
}

/** All objects in one mesh: vertices with position, normal, object and material; opaque triangles first. */
function meshOf(bake) {
  const vertices = [], opaque = [], clear = [];
  bake.objects.forEach((object, number) => {
    object.vertices = [];
    object.triangles.forEach((triangles, slot) => {
      const material = object.materials[slot], made = new Map();
      const list = bake.materials[material].opacity < 1 ? clear : opaque;
      for (const point of triangles) {
        if (!made.has(point)) {
          made.set(point, vertices.length / 8);
          object.vertices.push([vertices.length / 8, point]);
          vertices.push(...object.points.subarray(3 * point, 3 * point + 3), ...object.normals.subarray(3 * point, 3 * point + 3),
                        number, material);
        }
        list.push(made.get(point));
      }
    });
  });
  return {vertices: new Float32Array(vertices), indices: new Uint32Array(opaque.concat(clear)), opaque: opaque.length};
}

function buffer(gl, kind, data) {
  const made = gl.createBuffer();
  gl.bindBuffer(kind, made);
  gl.bufferData(kind, data, gl.DYNAMIC_DRAW);
  return made;
}

/** A texture of rows of two texels, four numbers each. */
function table(gl, numbers) {
  const rows = Math.max(numbers.length / 8, 1), texture = gl.createTexture();
  if (rows > gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error('There are more pieces than this device can draw.');
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 2, rows);
  if (numbers.length > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 2, rows, gl.RGBA, gl.FLOAT, numbers);
  for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
  return texture;
}

function program(gl, vertex, fragment) {
  const made = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(made, shader);
  }
  ['position', 'normal', 'style'].forEach((name, i) => gl.bindAttribLocation(made, i, name));
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  const places = new Map();
  const at = name => places.has(name) ? places.get(name) : places.set(name, gl.getUniformLocation(made, name)).get(name);
  return {program: made, at};
}

/** "#5d6673" as three numbers from 0 to 1. */
function rgbOf(hex) {
  const number = parseInt(hex.slice(1), 16);
  return [number >> 16 & 255, number >> 8 & 255, number & 255].map(value => value / 255);
}
