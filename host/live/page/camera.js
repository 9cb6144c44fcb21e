// Turns and moves the camera of `hyalite live` by pointer, wheel and keys. Loaded after live.js, which has the `camera`.
"use strict";

const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
const sub = (a, b) => add(a, b, -1);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const times = (a, s) => a.map((x) => x * s);
const length = (a) => Math.sqrt(dot(a, a));
const unit = (a) => times(a, 1 / length(a));
function turned(v, axis, angle) { // Rodrigues
  const c = Math.cos(angle), s = Math.sin(angle);
  return add(add(times(v, c), cross(axis, v), s), axis, dot(axis, v) * (1 - c));
}

const numbers = (v) => "[" + v.map((x) => Number(x.toPrecision(9))).join(", ") + "]";
function sendCamera() {
  sentRevision = state ? state.revision + 1 : 0;
  change({ settings: { "camera.position": numbers(camera.position), "camera.look_at": numbers(camera.look_at) } });
}

function orbit(dx, dy) { // radians
  if (!camera) { return; }
  const up = unit(camera.up);
  let arm = turned(sub(camera.position, camera.look_at), up, -dx);
  const right = unit(cross(up, arm));
  const polar = Math.acos(Math.min(1, Math.max(-1, dot(unit(arm), up))));
  const step = Math.min(polar - 0.02, Math.max(polar - (Math.PI - 0.02), dy)); // not over the poles
  arm = turned(arm, right, -step);
  camera.position = add(camera.look_at, arm);
  sendCamera();
}
function pan(dx, dy) { // fractions of the picture's height
  if (!camera) { return; }
  const arm = sub(camera.position, camera.look_at);
  const height = 2 * length(arm) * Math.tan(camera.fov * Math.PI / 360);
  const right = unit(cross(camera.up, arm));
  const shift = add(times(right, -dx * height), unit(cross(arm, right)), dy * height);
  camera.position = add(camera.position, shift);
  camera.look_at = add(camera.look_at, shift);
  sendCamera();
}
function zoom(factor) {
  if (!camera) { return; }
  camera.position = add(camera.look_at, sub(camera.position, camera.look_at), factor);
  sendCamera();
}
function resetCamera() {
  sentRevision = -1;
  camera = null;
  change({ settings: { "camera.position": null, "camera.look_at": null } });
}

const pointers = new Map();
let moved = 0;
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, event);
  moved = pointers.size > 1 ? 1e9 : 0;
  canvas.classList.add("dragging");
  canvas.focus({ preventScroll: true });
});
canvas.addEventListener("pointermove", (event) => {
  const before = pointers.get(event.pointerId);
  if (!before) { return; }
  const dx = event.clientX - before.clientX, dy = event.clientY - before.clientY;
  const size = canvas.getBoundingClientRect().height;
  moved += Math.abs(dx) + Math.abs(dy);
  if (pointers.size === 2) {
    const other = [...pointers.values()].find((p) => p.pointerId !== event.pointerId);
    const distance = (p) => Math.hypot(p.clientX - other.clientX, p.clientY - other.clientY);
    zoom(Math.max(0.5, Math.min(2, distance(before) / Math.max(1, distance(event)))));
  } else if (moved > 4) {
    if (event.shiftKey || before.button === 2 || (event.buttons & 2)) { pan(dx / size, dy / size); }
    else { orbit(dx / size * Math.PI, dy / size * Math.PI); }
  }
  pointers.set(event.pointerId, event);
});
function released(event) {
  const isClick = event.type === "pointerup" && pointers.has(event.pointerId) && moved <= 4;
  pointers.delete(event.pointerId);
  canvas.classList.toggle("dragging", pointers.size > 0);
  if (isClick) { inspect(event); }
}
canvas.addEventListener("pointerup", released);
canvas.addEventListener("pointercancel", released);
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("wheel", (event) => { event.preventDefault(); zoom(Math.exp(event.deltaY * 0.001)); }, { passive: false });
canvas.addEventListener("keydown", (event) => {
  const step = 0.1;
  const keys = {
    ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step],
  };
  if (keys[event.key]) {
    const [dx, dy] = keys[event.key];
    if (event.shiftKey) { pan(dx / 2, dy / 2); } else { orbit(dx, dy); }
  } else if (event.key === "+" || event.key === "=") { zoom(0.9); }
  else if (event.key === "-") { zoom(1 / 0.9); }
  else if (event.key === "0") { resetCamera(); }
  else if (event.key === "[" || event.key === "]") {
    $("exposure").value = Number($("exposure").value) + (event.key === "]" ? 0.25 : -0.25);
    showExposure();
  } else { return; }
  event.preventDefault();
});
$("reset-camera").addEventListener("click", resetCamera);
