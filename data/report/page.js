"use strict";

// Rows by verdict and words. Without this script all are there.
(() => {
  const form = document.getElementById("filter");
  const verdict = document.getElementById("verdict");
  const words = document.getElementById("words");
  const rows = [...document.querySelectorAll("#matrix tbody tr")];
  const texts = rows.map((row) => row.textContent.toLowerCase());
  function show() {
    const asked = words.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    rows.forEach((row, i) => {
      const fits = (!verdict.value || row.dataset.verdict === verdict.value) && asked.every((word) => texts[i].includes(word));
      row.hidden = !fits;
      shown += fits;
    });
    document.getElementById("shown").textContent = `${shown} of ${rows.length} rows`;
  }
  form.hidden = false;
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", show);
  for (const tile of document.querySelectorAll("a[data-filter]"))
    tile.addEventListener("click", () => { verdict.value = tile.dataset.filter; words.value = ""; show(); });
  show();
  // Paper shows all evidence of the rows that are shown.
  let opened = [];
  window.addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll("details:not([open])")];
    opened.forEach((details) => { details.open = true; });
  });
  window.addEventListener("afterprint", () => opened.forEach((details) => { details.open = false; }));
})();

// The packing: spheres in parallel projection, painted from the back to the front.
(() => {
  const holder = document.getElementById("packing-data");
  if (!holder) return;
  const data = JSON.parse(holder.textContent);
  const canvas = document.getElementById("viewer");
  const pen = canvas.getContext("2d");
  const hues = [205, 24, 160, 322, 40, 200, 275, 95, 0, 230, 60, 180];
  const levels = 8;  // of brightness, from the back to the front
  const sprites = new Map();

  // A frame's spheres: coordinates and radii over the largest extent, numbers of the fibers.
  function unpack(frame) {
    const bytes = Uint8Array.from(atob(frame.points), (letter) => letter.charCodeAt(0));
    const steps = new DataView(bytes.buffer);
    const count = bytes.length / 6;
    const at = new Float32Array(3 * count), radius = new Float32Array(count), fiber = new Int32Array(count);
    for (let i = 0; i < 3 * count; ++i) at[i] = steps.getUint16(2 * i, true) / 65535;
    for (let run = 0, i = 0; run < frame.runs.length; run += 3)
      for (const end = i + frame.runs[run + 1]; i < end; ++i) { fiber[i] = frame.runs[run]; radius[i] = frame.runs[run + 2]; }
    return {at, radius, fiber, count, time: frame.time, low: frame.low, high: frame.high};
  }

  // A lit sphere of a color at a depth, painted once for each radius in pixels.
  function sprite(hue, level, pixels) {
    const key = `${hue} ${level} ${pixels}`;
    if (sprites.has(key)) return sprites.get(key);
    const image = document.createElement("canvas");
    image.width = image.height = 2 * pixels + 2;
    const brush = image.getContext("2d"), middle = pixels + 1, light = 26 + 34 * level / (levels - 1);
    const shade = brush.createRadialGradient(middle - 0.35 * pixels, middle - 0.4 * pixels, 0.1 * pixels, middle, middle, pixels);
    shade.addColorStop(0, `hsl(${hue} 60% ${light + 22}%)`);
    shade.addColorStop(0.55, `hsl(${hue} 58% ${light}%)`);
    shade.addColorStop(1, `hsl(${hue} 60% ${0.5 * light}%)`);
    brush.fillStyle = shade;
    brush.beginPath();
    brush.arc(middle, middle, pixels, 0, 2 * Math.PI);
    brush.fill();
    sprites.set(key, image);
    return image;
  }

  const frames = data.frames.map(() => null);
  const start = {yaw: -0.5, pitch: 0.35, zoom: 1};
  const view = {...start, frame: data.frames.length - 1};
  let last = null, waiting = false;

  function draw() {
    waiting = false;
    const frame = frames[view.frame] ??= unpack(data.frames[view.frame]);
    const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    // The last frame's box decides where the middle is and how large all is: the view stays while time goes.
    const end = data.frames[data.frames.length - 1];
    const middle = end.low.map((low, c) => 0.5 * (low + end.high[c]));
    const extent = Math.hypot(...end.low.map((low, c) => end.high[c] - low));
    const scale = view.zoom * 0.96 * Math.min(width, height) / extent;
    const cosine = Math.cos(view.yaw), sine = Math.sin(view.yaw), rise = Math.sin(view.pitch), flat = Math.cos(view.pitch);
    const project = (x, y, z) => {
      const across = cosine * (x - middle[0]) - sine * (y - middle[1]), away = sine * (x - middle[0]) + cosine * (y - middle[1]);
      const up = z - middle[2];
      return [width / 2 + scale * across, height / 2 - scale * (flat * up + rise * away), flat * away - rise * up];
    };
    drawBox(frame, project);
    const depth = new Float32Array(frame.count), across = new Float32Array(frame.count), down = new Float32Array(frame.count);
    let nearest = Infinity, farthest = -Infinity;
    for (let i = 0; i < frame.count; ++i) {
      [across[i], down[i], depth[i]] = project(frame.at[3 * i], frame.at[3 * i + 1], frame.at[3 * i + 2]);
      nearest = Math.min(nearest, depth[i]);
      farthest = Math.max(farthest, depth[i]);
    }
    const order = [...depth.keys()].sort((a, b) => depth[b] - depth[a]);
    for (const i of order) {
      const size = scale * frame.radius[i], pixels = Math.max(2, Math.ceil(size * ratio));
      const level = Math.round((levels - 1) * (farthest - depth[i]) / (farthest - nearest || 1));
      const image = sprite(hues[frame.fiber[i] % hues.length], level, pixels), drawn = size * (1 + 1 / pixels);
      pen.drawImage(image, across[i] - drawn, down[i] - drawn, 2 * drawn, 2 * drawn);
    }
    const time = document.getElementById("time");
    if (time) time.textContent = `${frame.time.toPrecision(3)} s`;
  }

  function drawBox(frame, project) {
    const corner = (n) => project(...frame.low.map((low, c) => (n >> c) & 1 ? frame.high[c] : low));
    pen.strokeStyle = getComputedStyle(canvas).color;
    pen.globalAlpha = 0.35;
    pen.beginPath();
    for (let n = 0; n < 8; ++n)
      for (const bit of [1, 2, 4]) {
        if (n & bit) continue;
        const [from, to] = [corner(n), corner(n | bit)];
        pen.moveTo(from[0], from[1]);
        pen.lineTo(to[0], to[1]);
      }
    pen.stroke();
    pen.globalAlpha = 1;
  }

  function redraw() {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(draw);
  }
  function turn(yaw, pitch) {
    view.yaw += yaw;
    view.pitch = Math.max(-1.5, Math.min(1.5, view.pitch + pitch));
    redraw();
  }
  function come(factor) {
    view.zoom = Math.max(0.3, Math.min(12, view.zoom * factor));
    sprites.clear();
    redraw();
  }
  canvas.addEventListener("pointerdown", (event) => { last = event; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointerup", () => { last = null; });
  canvas.addEventListener("pointercancel", () => { last = null; });
  canvas.addEventListener("pointermove", (event) => {
    if (!last) return;
    turn(-0.008 * (event.clientX - last.clientX), 0.008 * (event.clientY - last.clientY));
    last = event;
  });
  const keys = {ArrowLeft: () => turn(0.1, 0), ArrowRight: () => turn(-0.1, 0), ArrowUp: () => turn(0, 0.1), ArrowDown: () => turn(0, -0.1),
    "+": () => come(1.2), "-": () => come(1 / 1.2)};
  canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
  document.getElementById("nearer").addEventListener("click", () => come(1.2));
  document.getElementById("farther").addEventListener("click", () => come(1 / 1.2));
  document.getElementById("reset").addEventListener("click", () => { Object.assign(view, start); sprites.clear(); redraw(); });
  const slider = document.getElementById("frame");
  if (slider) slider.addEventListener("input", () => { view.frame = Number(slider.value); redraw(); });
  document.querySelector("#packing .controls").hidden = false;
  new ResizeObserver(redraw).observe(canvas);
  draw();
})();
