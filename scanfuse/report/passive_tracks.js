'use strict';
// Tracks of passive sensors from above or from the side, scan by scan.
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const by = (id) => document.getElementById(id);
  const canvas = by('view'), slider = by('at'), shown = by('shown'), play = by('play'),
        side = by('side');
  const withLines = by('lines'), TRAIL = 40, TENTATIVE = 0;
  const state = {at: 0, timer: null};
  const frames = data.frames.map(
      (f) => ({
        scan: f.n,
        t: f.t,
        truth: f.g,
        // sensor, direction x y z, track (-1: clutter)
        lines: f.l.map((r) => ({sensor: r[0], d: [r[1], r[2], r[3]], id: r[4]})),
        tracks: f.k.map((r) => ({
                          id: r[0],
                          status: r[1],
                          p: [r[2], r[3], r[4]],
                          v: [r[5], r[6], r[7]],
                          P: [[r[8], r[9], r[10]], [r[9], r[11], r[12]], [r[10], r[12], r[13]]],
                          exists: r[14],
                        })),
      }));
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue(name).trim();
  const palette = () => [0, 1, 2, 3, 4, 5, 6].map((k) => colour('--s' + k));

  // What all frames cover, by axis, from 1 to 99 %: a track that runs away does not shrink the
  // rest.
  const range = [0, 1, 2].map((axis) => {
    const own = data.sensors.map((s) => s.p[axis]);
    const all = [];
    for (const f of frames) {
      for (const t of f.tracks)
        if (t.status !== TENTATIVE) all.push(t.p[axis]);
      for (const p of f.truth) all.push(p[axis]);
    }
    all.sort((a, b) => a - b);
    const pick = (q) => all.length ? [all[Math.floor(q * (all.length - 1))]] : [];
    const ends = own.concat(pick(0.01), pick(0.99));
    return [Math.min(...ends), Math.max(...ends)];
  });

  const camera = (w, h, up) => {
    const size = [range[0][1] - range[0][0], range[up][1] - range[up][0]];
    const room = 0.08 * Math.max(size[0], size[1]) + 1e-3;
    const scale = Math.min((w - 40) / (size[0] + 2 * room), (h - 40) / (size[1] + 2 * room));
    const x0 = (range[0][0] + range[0][1]) / 2, y0 = (range[up][0] + range[up][1]) / 2;
    const to = (p) => [w / 2 + scale * (p[0] - x0), h / 2 - scale * (p[up] - y0)];
    return {to, scale, x0, y0};
  };
  const path = (g, points) => {
    g.beginPath();
    points.forEach(([x, y], i) => i ? g.lineTo(x, y) : g.moveTo(x, y));
    g.stroke();
  };

  const grid = (g, w, h, cam) => {
    const steps = [1, 2, 5]
                      .flatMap((k) => [1, 10, 100, 1e3, 1e4, 1e5].map((m) => k * m))
                      .sort((a, b) => a - b);
    const step = steps.find((s) => s * cam.scale > 70) || 1e6;
    g.strokeStyle = colour('--line');
    g.fillStyle = colour('--muted');
    g.lineWidth = 1;
    const text = (v) => step >= 1000 ? v / 1000 + ' km' : v + ' m';
    const ends = (half, middle) =>
        [Math.ceil((middle - half / cam.scale) / step),
         Math.floor((middle + half / cam.scale) / step)];
    const [a, b] = ends(w / 2, cam.x0), [c, d] = ends(h / 2, cam.y0);
    for (let k = a; k <= b; k++) {
      const x = w / 2 + cam.scale * (k * step - cam.x0);
      path(g, [[x, 0], [x, h]]);
      g.fillText(text(k * step), x + 3, h - 4);
    }
    for (let k = c; k <= d; k++) {
      const y = h / 2 - cam.scale * (k * step - cam.y0);
      path(g, [[0, y], [w, y]]);
      g.fillText(text(k * step), 3, y - 3);
    }
  };

  // The ellipse that holds the target with 95 % in the plane shown.
  const ellipse = (g, t, cam, up) => {
    const a = t.P[0][0], b = t.P[0][up], c = t.P[up][up];
    const mean = (a + c) / 2, spread = Math.hypot((a - c) / 2, b),
          angle = 0.5 * Math.atan2(2 * b, a - c);
    const r =
        [mean + spread, mean - spread].map((v) => cam.scale * Math.sqrt(5.991 * Math.max(0, v)));
    const [x, y] = cam.to(t.p);
    g.beginPath();
    g.ellipse(x, y, r[0], r[1], -angle, 0, 2 * Math.PI);
    g.globalAlpha = 0.18;
    g.fill();
    g.globalAlpha = 1;
    g.stroke();
  };

  const drawLines = (g, frame, cam, up, colours) => {
    const found = new Map(frame.tracks.map((t) => [t.id, t]));
    const far = 3 * Math.max(...[0, up].map((k) => range[k][1] - range[k][0]), 1);
    for (const l of frame.lines) {
      const o = data.sensors[l.sensor].p, t = found.get(l.id);
      const length = t ? [0, 1, 2].reduce((s, k) => s + (t.p[k] - o[k]) * l.d[k], 0) : far;
      g.strokeStyle = t ? colours[l.id % 7] : colour('--muted');
      g.globalAlpha = t ? 0.5 : 0.2;
      path(g, [cam.to(o), cam.to(o.map((v, k) => v + length * l.d[k]))]);
    }
    g.globalAlpha = 1;
  };

  const drawTrails = (g, cam, colours) => {
    const trails = new Map();
    for (let k = Math.max(0, state.at - TRAIL); k <= state.at; k++) {
      for (const t of frames[k].tracks) {
        if (t.status === TENTATIVE) continue;
        if (!trails.has(t.id)) trails.set(t.id, []);
        trails.get(t.id).push(cam.to(t.p));
      }
    }
    g.lineWidth = 1.5;
    for (const [id, points] of trails) {
      g.strokeStyle = colours[id % 7];
      path(g, points);
    }
    g.lineWidth = 1;
  };

  const drawTrack = (g, t, cam, up, colours) => {
    const [x, y] = cam.to(t.p);
    g.strokeStyle = g.fillStyle = t.status === TENTATIVE ? colour('--muted') : colours[t.id % 7];
    ellipse(g, t, cam, up);
    g.beginPath();
    g.arc(x, y, t.status === TENTATIVE ? 2 : 3.5, 0, 2 * Math.PI);
    if (t.status === 2)
      g.stroke();
    else
      g.fill();
    if (t.status === TENTATIVE) return;
    g.fillStyle = colour('--ink');
    g.fillText(t.id, x + 7, y - 6);
  };

  const draw = () => {
    const frame = frames[state.at], up = side.value === 'side' ? 2 : 1;
    const ratio = window.devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
    canvas.width = Math.round(w * ratio);
    canvas.height = Math.round(h * ratio);
    const g = canvas.getContext('2d'), colours = palette(), cam = camera(w, h, up);
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.font = '11px system-ui, sans-serif';
    grid(g, w, h, cam);
    if (withLines.checked) drawLines(g, frame, cam, up, colours);
    drawTrails(g, cam, colours);
    g.strokeStyle = colour('--ink');
    for (const p of frame.truth) {
      const [x, y] = cam.to(p);
      g.beginPath();
      g.arc(x, y, 6, 0, 2 * Math.PI);
      g.stroke();
    }
    for (const t of frame.tracks) drawTrack(g, t, cam, up, colours);
    g.fillStyle = colour('--ink');
    for (const s of data.sensors) {
      const [x, y] = cam.to(s.p);
      g.fillRect(x - 5, y - 5, 10, 10);
      g.fillText(s.name, x + 9, y - 7);
    }
    const confirmed = frame.tracks.filter((t) => t.status !== TENTATIVE).length;
    shown.textContent = `scan ${frame.scan}, ${frame.t.toFixed(2)} s: ${confirmed} tracks, ${
        frame.lines.length} bearings`;
  };

  const show = (k) => {
    state.at = Math.min(Math.max(0, k), frames.length - 1);
    slider.value = state.at;
    draw();
  };
  const stop = () => {
    clearInterval(state.timer);
    state.timer = null;
    play.textContent = 'Play';
  };
  if (!frames.length) return;
  slider.max = frames.length - 1;
  slider.addEventListener('input', () => show(Number(slider.value)));
  side.addEventListener('change', draw);
  withLines.addEventListener('change', draw);
  window.addEventListener('resize', draw);
  play.addEventListener('click', () => {
    if (state.timer) {
      stop();
      return;
    }
    if (state.at === frames.length - 1) show(0);
    play.textContent = 'Pause';
    state.timer = setInterval(() => {
      if (state.at === frames.length - 1)
        stop();
      else
        show(state.at + 1);
    }, 100);
  });
  // #at=K opens the page at the K-th frame.
  const wanted = /^#at=(\d+)$/.exec(window.location.hash);
  show(wanted ? Number(wanted[1]) : Math.floor((frames.length - 1) / 2));
})();
