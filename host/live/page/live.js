// The page of `hyalite live`. Asks for the state, which the server answers when it changes (/api/state), for pixels when
// there is a new picture (/api/picture), and sends what the user changes (/api/change).
"use strict";

const $ = (id) => document.getElementById(id);
const VIEWS = [["picture", "picture"], ["normals", "normals"], ["depth", "depth"], ["bounces", "bounces"], ["photons", "photons"],
  ["radius", "radius of estimates"], ["global_map", "global map"], ["caustic_map", "caustic map"]];
const QUANTITIES = new Set(["depth", "bounces", "radius"]); // not light: scaled to their 99th percentile
// SETTINGS, a list of [key, label, kind, integrators that read it (none: all)], comes from settings.js.

let state = null;      // the last /api/state
let camera = null;     // the user's, ahead of the server's
let sentRevision = -1; // state.revision up to which the server's camera is older than the user's
let selected = null;   // [x, y] of the last clicked pixel

async function ask(path, body) {
  const options = body === undefined ? {}
    : { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) };
  const response = await fetch(path, options);
  if (!response.ok) {
    const failure = await response.json().catch(() => ({}));
    throw new Error(failure.error || response.statusText);
  }
  return response;
}

// ---- changes: sent one at a time; those made meanwhile are merged into one ----------------------------------------------
let pending = null, sending = false;
async function change(wanted) {
  pending = { ...pending, ...wanted, settings: { ...(pending || {}).settings, ...wanted.settings } };
  if (sending) { return; }
  sending = true;
  while (pending) {
    const body = pending;
    pending = null;
    try { await ask("api/change", body); } catch (error) { $("status").textContent = error.message; }
  }
  sending = false;
}

// ---- the picture --------------------------------------------------------------------------------------------------------
const canvas = $("picture");
let drawing = false, drawAgain = false;

function query() {
  const parameters = new URLSearchParams({ layer: $("layer").value || "picture", exposure: $("exposure").value,
    tone_map: $("tone-map").value, quantity: state && QUANTITIES.has(state.shown) ? "1" : "0" });
  return parameters.toString();
}

async function draw() {
  if (drawing) { drawAgain = true; return; }
  if (!state || !state.picture) { return; }
  drawing = true;
  try {
    const about = state.picture;
    const response = await ask("api/picture?" + query());
    const bytes = new Uint8ClampedArray(await response.arrayBuffer());
    const width = Number(response.headers.get("X-Width"));
    canvas.width = width;
    canvas.height = bytes.length / 4 / width;
    canvas.getContext("2d").putImageData(new ImageData(bytes, width), 0, 0);
    canvas.dataset.id = response.headers.get("X-Id");
    canvas.dataset.revision = about.revision;
    canvas.dataset.preview = about.preview;
    canvas.dataset.passes = about.passes;
    canvas.style.imageRendering = about.preview ? "auto" : "pixelated";
    fit();
  } catch (error) { /* the next state brings another picture */ }
  drawing = false;
  if (drawAgain) { drawAgain = false; draw(); }
}

// Scales the picture to the stage, in the proportions of the full-size picture.
function fit() {
  if (!state || !state.scene.camera) { return; }
  const [w, h] = state.scene.camera.resolution;
  const box = $("stage").getBoundingClientRect();
  const scale = Math.min(box.width / w, box.height / h);
  canvas.style.width = w * scale + "px";
  canvas.style.height = h * scale + "px";
  $("mark").hidden = !selected;
  if (selected) {
    $("mark").style.left = (box.width - w * scale) / 2 + (selected[0] + 0.5) * scale + "px";
    $("mark").style.top = (box.height - h * scale) / 2 + (selected[1] + 0.5) * scale + "px";
  }
}
new ResizeObserver(fit).observe($("stage"));

// ---- display ------------------------------------------------------------------------------------------------------------
function showExposure() {
  const stops = Number($("exposure").value);
  $("exposure-value").textContent = (stops > 0 ? "+" : "") + stops;
  showLinks();
  draw();
}
function showLinks() {
  $("save-png").href = "api/picture.png?" + query();
}
$("exposure").addEventListener("input", showExposure);
$("tone-map").addEventListener("change", showExposure);
$("layer").addEventListener("change", showExposure);
for (const [value, name] of VIEWS) { $("shown").add(new Option(name, value)); }
$("shown").addEventListener("change", () => change({ shown: $("shown").value }));

function showLayers(names) {
  const select = $("layer");
  const wanted = ["picture", ...names];
  if ([...select.options].map((option) => option.value).join() === wanted.join()) { return; }
  const before = select.value;
  select.replaceChildren(...wanted.map((name) => new Option(name === "picture" ? "all" : name, name)));
  select.value = wanted.includes(before) ? before : "picture";
}

// ---- settings -----------------------------------------------------------------------------------------------------------
for (const [key, name, kind] of SETTINGS) {
  const label = document.createElement("label");
  label.textContent = name;
  label.htmlFor = key;
  const field = document.createElement(Array.isArray(kind) ? "select" : "input");
  if (Array.isArray(kind)) { for (const word of kind) { field.add(new Option(word, word)); } }
  field.id = key;
  field.autocomplete = "off";
  if (kind === "number") { field.inputMode = "decimal"; }
  field.addEventListener("change", () => change({ settings: { [key]: field.value.trim() || null } }));
  $("settings").append(label, field);
}
$("settings").addEventListener("submit", (event) => event.preventDefault());
$("reset-all").addEventListener("click", () => { camera = null; sentRevision = -1; change({ reset: true, shown: "picture" }); });

function showSettings() {
  const scene = state.scene;
  if (!scene.settings) { return; }
  const values = { ...scene.settings, "camera.resolution": scene.camera.resolution.join("x") };
  const integrator = scene.settings["render.integrator"];
  for (const [key, , , readers] of SETTINGS) {
    const field = $(key);
    if (document.activeElement !== field) { field.value = values[key]; }
    field.classList.toggle("changed", key in state.overrides);
    field.classList.toggle("idle", Boolean(readers) && !readers.includes(integrator));
  }
  if (document.activeElement !== $("shown")) { $("shown").value = state.shown; }
}
$("copy-camera").addEventListener("click", async () => {
  if (!state || !state.scene.camera) { return; }
  const c = camera || state.scene.camera;
  const yaml = `camera: {position: ${numbers(c.position)}, look_at: ${numbers(c.look_at)}, up: ${numbers(c.up)}, fov: ${c.fov}, ` +
    `resolution: [${state.scene.camera.resolution.join(", ")}]}`;
  $("camera-yaml").textContent = yaml;
  $("camera-yaml").hidden = false;
  try { await navigator.clipboard.writeText(yaml); } catch (error) { /* the text is shown, to be copied by hand */ }
});

// ---- tabs ---------------------------------------------------------------------------------------------------------------
const TABS = [["settings", "Settings"], ["stages", "Stages"], ["path", "Path"], ["prints", "Print"], ["editor", "Editor"]];
function openTab(name) {
  for (const [id] of TABS) {
    $("tab-" + id).hidden = id !== name;
    $("open-" + id).setAttribute("aria-selected", id === name);
  }
  if (name === "editor") { openEditor(); }
}
for (const [id, name] of TABS) {
  const button = document.createElement("button");
  button.type = "button";
  button.id = "open-" + id;
  button.setAttribute("role", "tab");
  button.textContent = name;
  button.addEventListener("click", () => openTab(id));
  $("tabs").append(button);
}

// ---- errors, stages, status ---------------------------------------------------------------------------------------------
function element(tag, text, className) {
  const made = document.createElement(tag);
  if (text !== undefined) { made.textContent = text; }
  if (className) { made.className = className; }
  return made;
}

// An error in a file that several kernels include is shown once.
function merged(errors) {
  const found = new Map();
  for (const error of errors) {
    const what = error.kernel ? error.message.replace(`kernel '${error.kernel}': `, "") : error.message;
    const key = JSON.stringify([error.source, error.file, error.line, what]);
    const known = found.get(key);
    if (known && error.file && error.line) { known.kernels.push(error.kernel); } else {
      found.set(known ? key + found.size : key, { ...error, what, kernels: [error.kernel] });
    }
  }
  return found.values();
}

function showErrors() {
  const cards = [...merged(state.errors)].map((error) => {
    const card = element("div", undefined, "error");
    card.append(element("strong", error.source === "scene" ? "Scene: " : error.source === "setting" ? "Setting: " : ""));
    card.append((error.kernels.length > 1 ? `kernels ${error.kernels.map((name) => `'${name}'`).join(", ")}: ${error.what}`
      : error.message) + (error.hint ? ` (${error.hint})` : ""));
    if (error.file) {
      const place = (error.name || error.file) + (error.line ? ":" + error.line : "");
      card.append(document.createElement("br"));
      if (error.name) {
        const link = element("button", place, "place");
        link.type = "button";
        link.addEventListener("click", () => { openTab("editor"); openFile(error.name, error.line); });
        card.append(link);
      } else { card.append(element("span", place, "place")); }
    }
    if (error.excerpt.length) {
      const pre = element("pre");
      for (const { line, text } of error.excerpt) {
        pre.append(element("span", String(line).padStart(5) + "  " + text, line === error.line ? "here" : ""));
      }
      card.append(pre);
    }
    return card;
  });
  $("errors").replaceChildren(...cards);
}

function showStages() {
  const stages = [...state.picture.stages].sort((a, b) => b.seconds - a.seconds);
  const sum = stages.reduce((s, stage) => s + stage.seconds, 0) || 1;
  const head = element("tr");
  for (const name of ["stage", "dispatches", "ms", "share", ""]) { head.append(element("th", name)); }
  const rows = stages.map(({ name, seconds, dispatches }) => {
    const row = element("tr");
    row.append(element("td", name), element("td", dispatches), element("td", (1000 * seconds).toFixed(1)),
      element("td", (100 * seconds / sum).toFixed(1) + " %"));
    const bar = element("span", undefined, "share");
    bar.style.width = Math.round(90 * seconds / sum) + "px";
    const cell = element("td");
    cell.style.textAlign = "left";
    cell.append(bar);
    row.append(cell);
    return row;
  });
  $("stages").replaceChildren(head, ...rows);
}

function showStatus() {
  const about = state.picture;
  if (!about) { $("status").textContent = state.errors.length ? "no picture" : "starting …"; return; }
  const error = about.error === null ? "" : ` · estimated error ${about.error.toPrecision(3)}`;
  $("status").textContent = (about.preview ? `preview ${about.width} × ${about.height}`
    : `pass ${about.passes} of ${about.of_passes}${error}`) + ` · first pixels ${Math.round(1000 * state.first_pixel_seconds)} ms` +
    (state.reload_seconds ? ` · reload ${Math.round(1000 * state.reload_seconds)} ms` : "");
  $("badge").hidden = !about.preview;
  $("badge").textContent = "preview";
}

function show() {
  $("scene-name").textContent = state.name;
  if (state.scene.camera && (sentRevision < 0 || (pointers.size === 0 && state.revision > sentRevision))) {
    camera = structuredClone(state.scene.camera);
  }
  if (!camera && state.scene.camera) { camera = structuredClone(state.scene.camera); }
  showErrors();
  showStatus();
  showSettings();
  if (state.picture) {
    showLayers(state.picture.layers);
    showStages();
    const notes = [...(state.picture.warnings || []).map((text) => "Warning: " + text), ...[...state.notes].reverse()];
    $("notes").replaceChildren(...notes.map((text) => element("li", text)));
  }
  $("prints").textContent = state.prints.join("\n");
  $("open-prints").textContent = state.prints.length ? `Print (${state.prints.length})` : "Print";
  $("open-editor").textContent = state.errors.some((error) => error.name) ? "Editor ●" : "Editor";
  showLinks();
  showProblems();
}

// ---- the editor ---------------------------------------------------------------------------------------------------------
let editor = null, openName = null, wantedName = null, isDirty = false;
function openEditor() {
  if (!editor) {
    editor = makeEditor($("editor"), () => { isDirty = true; showFileState(); }, save);
    listFiles();
  }
  editor.setReadOnly(!(state && state.may_write));
  editor.refresh();
  showFileState();
}
async function listFiles() {
  try {
    const { files } = await (await ask("api/files")).json();
    $("file").replaceChildren(...files.map((name) => new Option(name, name)));
    if (!wantedName) { await openFile(files.find((name) => name.startsWith("scene/") && name.endsWith(".yaml")), 0); }
    $("file").value = wantedName;
  } catch (error) { $("file-state").textContent = error.message; }
}
async function openFile(name, line) {
  wantedName = name;
  if (openName !== name) {
    if (isDirty && !confirm(`Discard the changes to ${openName}?`)) {
      wantedName = openName;
      $("file").value = openName;
      return;
    }
    try {
      const { text } = await (await ask("api/file?name=" + encodeURIComponent(name))).json();
      if (wantedName !== name) { return; } // the user has opened another file meanwhile
      editor.open(text, name);
    } catch (error) { $("file-state").textContent = error.message; return; }
    openName = name;
    isDirty = false;
  }
  $("file").value = name;
  showFileState();
  showProblems();
  if (line) { editor.goTo(line); }
}
function showFileState(text) {
  const mayWrite = state && state.may_write;
  $("save").disabled = !mayWrite || !isDirty;
  $("file-state").textContent = text || (!mayWrite ? "read only: start hyalite live with --edit" : isDirty ? "not saved" : "");
}
async function save() {
  if (!openName || !isDirty || !state.may_write) { return; }
  const text = editor.text();
  try {
    await ask("api/file", { name: openName, text });
    isDirty = editor.text() !== text;
    showFileState(isDirty ? "" : "saved");
  } catch (error) { showFileState(error.message); }
}
function showProblems() {
  if (editor && state) {
    editor.showProblems(state.errors.filter((error) => error.name === openName && error.line > 0));
  }
}
$("save").addEventListener("click", save);
$("file").addEventListener("change", () => openFile($("file").value, 0));
addEventListener("beforeunload", (event) => { if (isDirty) { event.preventDefault(); } });

// ---- the server's state -------------------------------------------------------------------------------------------------
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

// A page that is not visible does not ask: browsers open few connections to a server, for all tabs together.
async function untilVisible() {
  while (document.hidden) {
    await new Promise((resolve) => document.addEventListener("visibilitychange", resolve, { once: true }));
  }
}

async function listen() {
  let seen = 0, drawn = null;
  while (true) {
    await untilVisible();
    try {
      const asked = performance.now();
      state = await (await ask("api/state?seen=" + seen)).json();
      state.scene = state.scene || {}; // none is loaded yet
      if (state.closing) { throw new Error("it has ended"); }
      // Answered at once without news: too many pages wait already
      if (state.version === seen && performance.now() - asked < 1000) { await pause(1000); }
      seen = state.version;
      show();
      if (state.picture && state.picture.id !== drawn) { drawn = state.picture.id; draw(); }
    } catch (error) {
      $("status").textContent = "hyalite live does not answer: " + error.message;
      await pause(1000);
      seen = 0;
    }
  }
}
openTab("settings");
listen();
