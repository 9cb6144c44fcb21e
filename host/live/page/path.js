// Shows the path of the clicked pixel on the device and in the reference. Loaded after live.js.
"use strict";

const three = (v) => v.map((x) => Number(x.toPrecision(7))).join(" ");
function vertexCard(depth, device, twin, path) {
  const card = element("div", undefined, "vertex" + (depth === path.differs_at ? " differs" : ""));
  card.append(element("h3", `Vertex ${depth}` + (depth === path.differs_at
    ? `: device and reference first differ here, in ${path.what}: ${path.cause || "no known cause"}` : "")));
  const table = element("table");
  const head = element("tr");
  for (const name of ["", "device", "reference"]) { head.append(element("th", name)); }
  table.append(head);
  const rows = [["hits", (v) => v.hit ? `object ${v.object}, ${v.material || "no material"}, ${v.side}` : "nothing"],
    ["position", (v) => v.position ? three(v.position) : ""], ["normal", (v) => v.normal ? three(v.normal) : ""],
    ["throughput", (v) => three(v.throughput)], ["medium", (v) => v.medium], ["then", (v) => v.choice]];
  for (const [name, of] of rows) {
    const row = element("tr");
    row.append(element("td", name), element("td", device ? of(device) : "–"), element("td", twin ? of(twin) : "–"));
    table.append(row);
  }
  card.append(table);
  return card;
}

async function inspect(event) {
  if (!state || !state.scene.camera) { return; }
  const box = canvas.getBoundingClientRect();
  const [w, h] = state.scene.camera.resolution;
  const x = Math.min(w - 1, Math.max(0, Math.floor((event.clientX - box.left) / box.width * w)));
  const y = Math.min(h - 1, Math.max(0, Math.floor((event.clientY - box.top) / box.height * h)));
  selected = [x, y];
  fit();
  openTab("path");
  $("path-title").textContent = `Path of pixel ${x}, ${y}: waiting for it …`;
  $("path").replaceChildren();
  ask("api/change", { pixel: y * w + x }).catch(() => {});
  try {
    const answer = await (await ask("api/inspect", { x, y })).json();
    if (answer.error) { throw new Error(answer.error); }
    const path = answer.path;
    $("path-title").textContent = `Path of pixel ${x}, ${y} in the first pass: ` +
      (path.differs_at ? `device and reference first differ at vertex ${path.differs_at}` : "device and reference agree vertex by vertex");
    const cards = path.twin.map((twin) => vertexCard(twin.depth,
      path.device.find((v) => v.depth === twin.depth && v.seed === twin.seed), twin, path));
    for (const device of path.device) {
      if (!path.twin.some((v) => v.depth === device.depth && v.seed === device.seed)) {
        cards.push(vertexCard(device.depth, device, null, path));
      }
    }
    $("path").replaceChildren(...cards);
  } catch (error) { $("path-title").textContent = `Pixel ${x}, ${y}: ${error.message}`; }
}
