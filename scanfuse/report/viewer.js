'use strict';
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const frames = data.frames;
  const by = (id) => document.getElementById(id);
  const view = by('view'), strip = by('strip');
  const {TENTATIVE, COASTING, corners, outline, colourOf} = marks;
  const state = {
    at: 0, playing: false, speed: 1, follow: true, picked: null,
    scale: 8, x: 0, y: 0,  // pixels per metre, and what is in the middle (ego or world frame)
  };

  // Columns of a track row: see track_data in page_data.cpp.
  const trackOf = (r) => ({
    id: r[0], name: r[1], status: r[2], x: r[3], y: r[4], heading: r[5], length: r[6], width: r[7],
    vx: r[8], vy: r[9], pxx: r[10], pxy: r[11], pyy: r[12], mx: r[13], my: r[14], hidden: r[15],
  });
  for (const frame of frames) frame.k = frame.k.map(trackOf);

  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const unpack = (frame) => {
    if (frame.xy) return;
    const raw = new DataView(bytes(frame.p).buffer);
    frame.xy = new Float32Array(raw.byteLength / 2);
    for (let i = 0; i < frame.xy.length; i++) frame.xy[i] = raw.getInt16(2 * i, true) / 100;
    frame.group = bytes(frame.c);
  };

  let colours = {};

  const sized = (canvas, height) => {
    const ratio = window.devicePixelRatio || 1;
    const w = canvas.clientWidth, h = height || canvas.clientHeight;
    if (height) canvas.style.height = height + 'px';
    if (canvas.width !== Math.round(w * ratio) || canvas.height !== Math.round(h * ratio)) {
      canvas.width = Math.round(w * ratio);
      canvas.height = Math.round(h * ratio);
    }
    const g = canvas.getContext('2d');
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    return {g, w, h};
  };

  // The screen shows forward up when following the ego vehicle, north (world y) up otherwise.
  const camera = (frame, w, h) => {
    const [ex, ey, eh] = frame.e;
    const turn = state.follow ? Math.PI / 2 - eh : 0;
    const c = Math.cos(turn), s = Math.sin(turn);
    const ox = state.follow ? ex : 0, oy = state.follow ? ey : 0;
    return (x, y) => {
      const dx = x - ox, dy = y - oy;
      return [w / 2 + state.scale * (c * dx - s * dy - state.x), h / 2 - state.scale * (s * dx + c * dy - state.y)];
    };
  };

  const drawGrid = (g, w, h, to, frame) => {
    const steps = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
    const step = steps.find((m) => m * state.scale > 60) || 2000;
    const [ex, ey] = frame.e;
    g.strokeStyle = colours.line;
    g.lineWidth = 1;
    g.fillStyle = colours.muted;
    g.font = '11px system-ui, sans-serif';
    for (let r = step; r * state.scale < 2 * Math.max(w, h) && r < 40 * step; r += step) {
      const p = to(ex, ey);
      g.beginPath();
      g.arc(p[0], p[1], r * state.scale, 0, 2 * Math.PI);
      g.stroke();
      g.fillText(r + ' m', p[0] + 0.6 * r * state.scale + 3, p[1] - 0.8 * r * state.scale - 3);
    }
  };

  const drawPoints = (g, to, frame) => {
    unpack(frame);
    const [ex, ey, eh] = frame.e, c = Math.cos(eh), s = Math.sin(eh);
    const size = Math.max(1.5, Math.min(3, state.scale / 5));
    for (let i = 0; i < frame.group.length; i++) {
      const x = frame.xy[2 * i], y = frame.xy[2 * i + 1], p = to(ex + c * x - s * y, ey + s * x + c * y);
      const cluster = frame.group[i];
      g.fillStyle = !cluster ? colours.noise : by('clusters').checked ? colours.clusters[(cluster * 3) % 7] : colours.returns;
      g.fillRect(p[0] - size / 2, p[1] - size / 2, size, size);
    }
  };

  const drawEgo = (g, to, frame) => {
    const [x, y, heading] = frame.e;
    outline(g, to, corners({x, y, heading, length: 1.6, width: 1.2}).slice(1, 3).concat([[x + Math.cos(heading) * 1.2, y + Math.sin(heading) * 1.2]]));
    g.fillStyle = colours.ink;
    g.fill();
  };

  const drawTruth = (g, to, frame) => {
    g.setLineDash([2, 3]);
    g.strokeStyle = colours.ink;
    g.lineWidth = 1.4;
    for (const r of frame.g || []) {
      outline(g, to, corners({x: r[2], y: r[3], heading: r[4], length: r[5], width: r[6]}));
      g.stroke();
    }
    g.setLineDash([]);
  };

  const drawTrails = (g, to, frame) => {
    const alive = new Set(frame.k.filter((t) => t.status !== TENTATIVE).map((t) => t.id)), last = new Map();
    g.lineWidth = 1.3;
    for (let i = Math.max(0, state.at - 60); i <= state.at; i++) {
      for (const t of frames[i].k) {
        if (!alive.has(t.id)) continue;
        const p = to(t.x, t.y), q = last.get(t.id);
        if (q) {
          g.globalAlpha = 0.15 + 0.5 * (1 - (state.at - i) / 60);
          g.strokeStyle = colourOf(colours, t.name);
          g.beginPath();
          g.moveTo(q[0], q[1]);
          g.lineTo(p[0], p[1]);
          g.stroke();
        }
        last.set(t.id, p);
      }
    }
    g.globalAlpha = 1;
  };

  const drawTentative = (g, to, t) => {
    g.globalAlpha = state.picked === t.id ? 1 : 0.35;
    g.strokeStyle = colours.muted;
    g.lineWidth = 1;
    outline(g, to, corners(t));
    g.stroke();
    g.globalAlpha = 1;
  };
  const drawTrack = (g, to, t, sensor) => {
    const picked = state.picked === t.id;
    g.globalAlpha = t.status === COASTING ? 0.5 : 1;
    g.strokeStyle = g.fillStyle = colourOf(colours, t.name);
    if (by('ellipses').checked) marks.ellipse(g, to, t);
    marks.box(g, to, t, sensor, picked ? 4 : 2.6);
    marks.arrow(g, to, t);
    g.globalAlpha = 1;
  };
  const drawTracks = (g, to, frame) => {
    if (by('tentative').checked) frame.k.filter((t) => t.status === TENTATIVE).forEach((t) => drawTentative(g, to, t));
    const shown = frame.k.filter((t) => t.status !== TENTATIVE);
    shown.forEach((t) => drawTrack(g, to, t, frame.s));
    const [ex, ey] = frame.e, label = marks.labeller(g, colours, to(ex, ey));
    const rank = (t) => (t.id === state.picked ? -1 : Math.hypot(t.x - ex, t.y - ey));  // the nearest first
    for (const t of [...shown].sort((a, b) => rank(a) - rank(b) || a.id - b.id)) {
      const speed = Math.hypot(t.vx, t.vy), reach = state.scale * (t.length + t.width) / 4 + 6;
      label(t.id + (speed > 0.3 ? ' · ' + speed.toFixed(1) + ' m/s' : ''), to(t.x, t.y), Math.min(reach, 60), t.id === state.picked);
    }
  };

  const drawView = () => {
    const {g, w, h} = sized(view);
    g.fillStyle = colours.paper;
    g.fillRect(0, 0, w, h);
    const frame = frames[state.at];
    if (!frame) { g.fillStyle = colours.muted; g.fillText('no frames', 20, 30); return; }
    const to = camera(frame, w, h);
    drawGrid(g, w, h, to, frame);
    drawPoints(g, to, frame);
    if (by('trails').checked) drawTrails(g, to, frame);
    drawEgo(g, to, frame);
    if (by('truths').checked) drawTruth(g, to, frame);
    drawTracks(g, to, frame);
    by('clock').value = 'frame ' + frame.f + ' · ' + frame.t.toFixed(2) + ' s';
    by('seek').value = state.at;
    const t = frame.k.find((k) => k.id === state.picked);
    by('picked').textContent = state.picked === null ? '' : t ?
      'track ' + t.id + ': ' + t.name + ', ' + ['tentative', 'confirmed', 'coasting'][t.status] + ', ' +
      Math.hypot(t.vx, t.vy).toFixed(1) + ' m/s, ' + t.length.toFixed(1) + ' x ' + t.width.toFixed(1) + ' m' :
      'track ' + state.picked + ': not here';
  };

  const lives = timeline(frames);
  const drawStrip = () => {
    const {g, w, h} = sized(strip, lives.height);
    lives.draw(g, w, h, colours, state.at, state.picked);
  };
  by('rows').textContent = lives.confirmed > lives.rows.length ?
    'The ' + lives.rows.length + ' longest of ' + lives.confirmed + ' confirmed tracks. ' : '';

  let pending = false;
  const draw = () => {
    if (pending) return;
    pending = true;
    requestAnimationFrame(() => { pending = false; drawView(); drawStrip(); });
  };

  const go = (i) => { state.at = Math.max(0, Math.min(frames.length - 1, i)); draw(); };
  let clock = 0, last = 0;
  const tick = (now) => {
    if (!state.playing) return;
    clock += Math.min(0.25, (now - last) / 1000) * state.speed;
    last = now;
    while (state.at < frames.length - 1) {
      const gap = Math.max(0.001, Math.min(1, frames[state.at + 1].t - frames[state.at].t));
      if (clock < gap) break;
      clock -= gap;
      state.at++;
    }
    draw();
    if (state.at >= frames.length - 1) play(false);
    else requestAnimationFrame(tick);
  };
  const play = (on) => {
    state.playing = on && frames.length > 1;
    by('play').textContent = state.playing ? 'Pause' : 'Play';
    if (!state.playing) return;
    if (state.at >= frames.length - 1) state.at = 0;
    clock = 0;
    last = performance.now();
    requestAnimationFrame(tick);
  };

  // Shows the tracks and the nearer returns of the current frame (following) or all paths (world).
  const fit = () => {
    const xs = [], ys = [];
    const put = (x, y) => { xs.push(x); ys.push(y); };
    const frame = frames[state.at];
    if (!frame) return;
    if (state.follow) {
      unpack(frame);
      for (let i = 0; i < frame.group.length; i++) {
        if (Math.hypot(frame.xy[2 * i], frame.xy[2 * i + 1]) < 40) put(-frame.xy[2 * i + 1], frame.xy[2 * i]);
      }
      put(0, 0);
      put(0, 12);
      const [ex, ey, eh] = frame.e, c = Math.cos(eh), s = Math.sin(eh);
      for (const t of frame.k.filter((k) => k.status !== TENTATIVE)) {
        const dx = t.x - ex, dy = t.y - ey;
        if (Math.hypot(dx, dy) < 60) put(s * dx - c * dy, c * dx + s * dy);
      }
    } else {
      for (const f of frames) { put(f.e[0], f.e[1]); f.k.forEach((t) => put(t.x, t.y)); }
    }
    const range = (v) => v.reduce((r, x) => [Math.min(r[0], x), Math.max(r[1], x)], [Infinity, -Infinity]);
    const [x0, x1] = range(xs), [y0, y1] = range(ys);
    state.x = (x0 + x1) / 2;
    state.y = (y0 + y1) / 2;
    state.scale = Math.max(0.2, Math.min(60, 0.9 * Math.min(view.clientWidth / (x1 - x0 + 4), view.clientHeight / (y1 - y0 + 4))));
    draw();
  };
  const zoom = (factor, px, py) => {
    const before = state.scale, w = view.clientWidth, h = view.clientHeight;
    state.scale = Math.max(0.1, Math.min(400, before * factor));
    const dx = px - w / 2, dy = h / 2 - py;
    state.x += dx / before - dx / state.scale;
    state.y += dy / before - dy / state.scale;
    draw();
  };
  const pan = (dx, dy) => { state.x -= dx / state.scale; state.y += dy / state.scale; draw(); };
  const setFollow = (on) => { state.follow = on; by('follow').checked = on; fit(); };
  const pick = (id) => { state.picked = id; draw(); };

  const trackAt = (px, py) => {
    const frame = frames[state.at];
    if (!frame) return null;
    const to = camera(frame, view.clientWidth, view.clientHeight);
    let best = null, least = 30;
    for (const t of frame.k) {
      const p = to(t.x, t.y), d = Math.hypot(p[0] - px, p[1] - py);
      if (d < Math.max(least, 0)) { least = d; best = t.id; }
    }
    return best;
  };

  let drag = null;
  view.addEventListener('pointerdown', (e) => {
    drag = {x: e.offsetX, y: e.offsetY, moved: 0};
    view.setPointerCapture(e.pointerId);
  });
  view.addEventListener('pointermove', (e) => {
    if (!drag) return;
    const dx = e.offsetX - drag.x, dy = e.offsetY - drag.y;
    drag = {x: e.offsetX, y: e.offsetY, moved: drag.moved + Math.abs(dx) + Math.abs(dy)};
    if (drag.moved > 4) pan(dx, dy);
  });
  view.addEventListener('pointerup', (e) => {
    if (drag && drag.moved <= 4) pick(trackAt(e.offsetX, e.offsetY));
    drag = null;
  });
  view.addEventListener('wheel', (e) => {
    e.preventDefault();
    zoom(Math.exp(-e.deltaY / 500), e.offsetX, e.offsetY);
  }, {passive: false});
  strip.addEventListener('click', (e) => {
    const row = lives.rowAt(e.offsetY);
    if (row) state.picked = row.id;
    go(lives.frameAt(strip.clientWidth, e.offsetX));
  });
  document.querySelectorAll('tr[data-track]').forEach((row) => {
    row.addEventListener('click', () => pick(Number(row.dataset.track)));
  });

  const keys = {
    ' ': () => play(!state.playing), ArrowLeft: () => { play(false); go(state.at - 1); },
    ArrowRight: () => { play(false); go(state.at + 1); }, Home: () => go(0), End: () => go(frames.length - 1),
    '+': () => zoom(1.25, view.clientWidth / 2, view.clientHeight / 2),
    '=': () => zoom(1.25, view.clientWidth / 2, view.clientHeight / 2),
    '-': () => zoom(0.8, view.clientWidth / 2, view.clientHeight / 2),
    w: () => pan(0, 40), s: () => pan(0, -40), a: () => pan(40, 0), d: () => pan(-40, 0),
    f: () => setFollow(!state.follow), 0: fit, Escape: () => pick(null),
  };
  document.addEventListener('keydown', (e) => {
    if (e.ctrlKey || e.metaKey || e.altKey || /SELECT/.test(e.target.tagName)) return;
    if (e.target.tagName === 'BUTTON' && e.key === ' ') return;
    const action = keys[e.key.length === 1 ? e.key.toLowerCase() : e.key];
    if (!action) return;
    e.preventDefault();
    action();
  });
  by('play').onclick = () => play(!state.playing);
  by('back').onclick = () => { play(false); go(state.at - 1); };
  by('next').onclick = () => { play(false); go(state.at + 1); };
  by('seek').max = Math.max(0, frames.length - 1);
  by('seek').oninput = (e) => { play(false); go(Number(e.target.value)); };
  by('speed').onchange = (e) => { state.speed = Number(e.target.value); };
  by('follow').onchange = (e) => setFollow(e.target.checked);
  by('fit').onclick = fit;
  for (const id of ['trails', 'ellipses', 'truths', 'tentative', 'clusters']) by(id).onchange = draw;
  window.addEventListener('resize', draw);
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { colours = marks.readColours(); draw(); });

  colours = marks.readColours();
  const wanted = /^#frame=(\d+)$/.exec(location.hash);
  if (wanted) state.at = Math.max(0, frames.findIndex((f) => f.f >= Number(wanted[1])));
  fit();
})();
