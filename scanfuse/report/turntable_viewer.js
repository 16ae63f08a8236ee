'use strict';
(() => {
  const parts = JSON.parse(document.getElementById('scene').textContent);
  const canvas = document.getElementById('space');
  const lines = parts.flatMap((part) => (part.k === 'lines' ? part.p : []));
  const low = [0, 1, 2].map((k) => Math.min(...lines.map((p) => p[k])));
  const high = [0, 1, 2].map((k) => Math.max(...lines.map((p) => p[k])));
  const middle = low.map((v, k) => (v + high[k]) / 2);
  const reach = Math.hypot(...low.map((v, k) => high[k] - v)) / 2 || 1;
  const start = {yaw: -0.7, pitch: 0.45, zoom: 1};
  const view = {...start};
  let asked = false;

  // The camera frame has y down: from behind the camera, a little above.
  const turned = (p) => {
    const x = p[0] - middle[0], y = p[1] - middle[1], z = p[2] - middle[2];
    const cy = Math.cos(view.yaw), sy = Math.sin(view.yaw);
    const cp = Math.cos(view.pitch), sp = Math.sin(view.pitch);
    const across = cy * x + sy * z, away = -sy * x + cy * z;
    return [across, cp * y - sp * away, sp * y + cp * away];
  };

  const draw = () => {
    asked = false;
    const ratio = window.devicePixelRatio || 1;
    const w = canvas.clientWidth, h = canvas.clientHeight;
    canvas.width = Math.round(w * ratio);
    canvas.height = Math.round(h * ratio);
    const g = canvas.getContext('2d');
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.font = '12px system-ui, sans-serif';
    const style = getComputedStyle(document.documentElement);
    const colours = {};
    const colour = (name) => (colours[name] ??= style.getPropertyValue(name).trim() || '#888');
    const scale = view.zoom * Math.min(w, h) * 0.55 / reach;
    const place = (p) => {
      const [x, y, z] = turned(p);
      const near = 1 / Math.max(1 + z / (4 * reach), 0.1);
      return [w / 2 + x * scale * near, h / 2 + y * scale * near];
    };
    const labels = [];
    for (const part of parts) {
      const at = part.p.map(place);
      if (part.k === 'dots') {
        g.fillStyle = colour(part.c);
        g.globalAlpha = 0.7;
        for (const [x, y] of at) g.fillRect(x - part.w / 2, y - part.w / 2, part.w, part.w);
        g.globalAlpha = 1;
        continue;
      }
      g.strokeStyle = colour(part.c);
      g.lineWidth = part.w;
      g.beginPath();
      at.forEach(([x, y], k) => (k ? g.lineTo(x, y) : g.moveTo(x, y)));
      g.stroke();
      if (part.l) labels.push([part.l, at[at.length - 1]]);
    }
    g.lineWidth = 3;
    g.strokeStyle = colour('--card');
    g.fillStyle = colour('--ink');
    for (const [text, [x, y]] of labels) {
      g.strokeText(text, x + 5, y - 4);
      g.fillText(text, x + 5, y - 4);
    }
  };
  const redraw = () => {
    if (!asked) requestAnimationFrame(draw);
    asked = true;
  };

  const turn = (dx, dy) => {
    view.yaw += dx;
    view.pitch = Math.max(-1.5, Math.min(1.5, view.pitch + dy));
    redraw();
  };
  const zoom = (factor) => {
    view.zoom = Math.max(0.2, Math.min(20, view.zoom * factor));
    redraw();
  };
  let last = null;
  canvas.addEventListener('pointerdown', (e) => {
    last = [e.clientX, e.clientY];
    canvas.setPointerCapture(e.pointerId);
  });
  canvas.addEventListener('pointermove', (e) => {
    if (!last) return;
    turn((e.clientX - last[0]) * 0.008, (e.clientY - last[1]) * -0.008);
    last = [e.clientX, e.clientY];
  });
  for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => (last = null));
  canvas.addEventListener('wheel', (e) => {
    e.preventDefault();
    zoom(Math.exp(-e.deltaY * 0.001));
  }, {passive: false});
  canvas.addEventListener('keydown', (e) => {
    const keys = {
      ArrowLeft: () => turn(-0.1, 0), ArrowRight: () => turn(0.1, 0), ArrowUp: () => turn(0, 0.1),
      ArrowDown: () => turn(0, -0.1), '+': () => zoom(1.2), '=': () => zoom(1.2), '-': () => zoom(1 / 1.2),
      0: () => { Object.assign(view, start); redraw(); },
    };
    if (!keys[e.key]) return;
    e.preventDefault();
    keys[e.key]();
  });
  window.addEventListener('resize', redraw);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  draw();
})();
