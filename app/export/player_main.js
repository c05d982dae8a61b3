'use strict';

const kSpeeds = [0.02, 0.05, 0.1, 0.25, 0.5, 1, 2];

/** Controller of the page that plays a bake. */
class Player {
  constructor() {
    this.element = id => document.getElementById(id);
    this.bake = readBake();
    this.breaks = breaksPerFrame(this.bake);
    this.view = new View(this.element('canvas'), this.bake);
    Object.assign(this, {frame: 0, playing: false, speed: 1, selected: -1, there: 0, last: this.bake.times.length - 1});
    const pieces = this.bake.objects.filter(object => object.body !== null).length;
    this.element('title').append(this.bake.scene, made('small', `${pieces} ${pieces === 1 ? 'piece' : 'pieces'}, ${this.duration()}`));
    for (const speed of kSpeeds) this.element('speed').add(new Option(`${speed}×`, speed, speed === 1, speed === 1));
    this.listen();
    this.obeyHash();
    this.update();
    requestAnimationFrame(now => this.tick(now, now));
  }

  duration() { return quantity(this.bake.times[this.last] - this.bake.times[0], 's'); }
  /** Time at a frame, which may be fractional [s]. */
  time() {
    const i = Math.floor(this.frame), times = this.bake.times, next = times[Math.min(i + 1, this.last)];
    return times[i] + (this.frame - i) * (next - times[i]);
  }

  setFrame(frame) {
    this.frame = Math.min(Math.max(frame, 0), this.last);
    this.update();
  }
  setSpeed(speed) {
    this.speed = kSpeeds.includes(speed) ? speed : kSpeeds.reduce((a, b) => Math.abs(b - speed) < Math.abs(a - speed) ? b : a);
    this.element('speed').value = this.speed;
  }
  play(playing) {
    if (playing && this.frame >= this.last) this.frame = 0;
    this.playing = playing && this.last > 0;
    this.element('play').textContent = this.playing ? 'Pause' : 'Play';
    this.update();
  }
  select(number) {
    this.selected = this.view.selected = number;
    showPiece(this.element('piece'), this.bake, number, other => this.select(other), () => this.select(-1));
    this.update();
  }
  numberOf(name) { return this.bake.objects.findIndex(object => object.name === name); }

  /** "#frame=30&select=pane_0012&speed=0.1&play=1" */
  obeyHash() {
    const asked = new URLSearchParams(location.hash.slice(1));
    if (asked.has('speed')) this.setSpeed(Number(asked.get('speed')) || 1);
    if (asked.has('frame')) this.setFrame(Number(asked.get('frame')) || 0);
    if (asked.has('select')) this.select(this.numberOf(asked.get('select')));
    if (asked.get('play') === '1') this.play(true);
  }

  tick(now, before) {
    if (this.playing) {
      const pace = this.bake.framesPerSecond * this.speed, next = this.frame + pace * Math.min((now - before) / 1000, 0.25);
      this.setFrame(next > this.last ? 0 : next);
    }
    if (this.stale) this.draw();
    requestAnimationFrame(then => this.tick(then, now));
  }

  update() { this.stale = true; }
  draw() {
    this.stale = false;
    this.there = this.view.place(this.frame);
    this.view.draw();
    drawBar(this.element('bar'), this.breaks, this.frame);
    this.element('clock').textContent = `${this.time().toFixed(3)} s, frame ${Math.round(this.frame)} of ${this.last}`;
  }

  listen() {
    this.element('play').onclick = () => this.play(!this.playing);
    this.element('speed').onchange = event => this.setSpeed(Number(event.target.value));
    listenToView(this);
    listenToBar(this);
    addEventListener('keydown', event => keyPressed(this, event));
    addEventListener('resize', () => this.update());
    addEventListener('hashchange', () => this.obeyHash());
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.update());
  }
}

/** One pointer orbits or pans, two zoom; a short motion is a click. */
function listenToView(player) {
  const canvas = player.element('canvas'), camera = player.view.camera, held = new Map();
  let moved = 0;
  const gap = () => {
    const [a, b] = [...held.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  canvas.onpointerdown = event => {
    if (event.isTrusted) canvas.setPointerCapture(event.pointerId);
    if (held.size === 0) moved = 0;
    held.set(event.pointerId, {x: event.offsetX, y: event.offsetY});
    canvas.classList.add('held');
  };
  canvas.onpointermove = event => {
    const from = held.get(event.pointerId);
    if (!from) return;
    const before = held.size === 2 ? gap() : 0;
    const right = (event.offsetX - from.x) / canvas.clientHeight, down = (event.offsetY - from.y) / canvas.clientHeight;
    moved += Math.abs(event.offsetX - from.x) + Math.abs(event.offsetY - from.y);
    Object.assign(from, {x: event.offsetX, y: event.offsetY});
    if (held.size === 2) camera.zoom(before / Math.max(gap(), 1));
    if (held.size === 2 || event.shiftKey || event.buttons & 6) camera.move(right / held.size, down / held.size);
    else camera.turn(4 * right, 4 * down);
    player.update();
  };
  canvas.onpointerup = canvas.onpointercancel = event => {
    held.delete(event.pointerId);
    canvas.classList.toggle('held', held.size > 0);
    if (event.type === 'pointerup' && moved < 5 && event.button === 0) player.select(player.view.pick(event.offsetX, event.offsetY));
  };
  canvas.onwheel = event => {
    event.preventDefault();
    camera.zoom(Math.exp(Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY) / 500, 0.3)));
    player.update();
  };
  canvas.oncontextmenu = event => event.preventDefault();
}

function listenToBar(player) {
  const bar = player.element('bar');
  const follow = event => {
    player.play(false);
    player.setFrame(Math.round(player.last * event.offsetX / Math.max(bar.clientWidth, 1)));
  };
  bar.onpointerdown = event => {
    if (event.isTrusted) bar.setPointerCapture(event.pointerId);
    follow(event);
  };
  bar.onpointermove = event => { if (event.buttons) follow(event); };
}

function keyPressed(player, event) {
  const step = by => {
    player.play(false);
    player.setFrame(Math.round(player.frame) + by);
  };
  const faster = by => player.setSpeed(kSpeeds[Math.min(Math.max(kSpeeds.indexOf(player.speed) + by, 0), kSpeeds.length - 1)]);
  const actions = {
    ' ': () => player.play(!player.playing),
    ArrowLeft: () => step(-1),
    ArrowRight: () => step(1),
    '[': () => faster(-1),
    ']': () => faster(1),
    Home: () => player.view.frameAll(),
    Escape: () => player.select(-1),
  };
  if (!actions[event.key] || event.ctrlKey || event.metaKey || event.target.tagName === 'SELECT') return;
  event.preventDefault();
  actions[event.key]();
  player.update();
}

try {
  window.griffith = new Player();
} catch (error) {
  const problem = document.getElementById('problem');
  problem.hidden = false;
  problem.textContent = error.message;
}
