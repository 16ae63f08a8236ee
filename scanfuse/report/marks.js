'use strict';
// How things look from above: pure drawing, told everything.
const marks = (() => {
  const TENTATIVE = 0, COASTING = 2;
  const CLASSES = ['vehicle', 'pedestrian', 'cyclist', 'other'];
  const FASTEST = 60;  // m/s: longer arrows are cut

  const readColours = () => {
    const style = getComputedStyle(document.documentElement);
    const get = (name) => style.getPropertyValue(name).trim();
    return {
      paper: get('--paper'), card: get('--card'), ink: get('--ink'), muted: get('--muted'), line: get('--line'),
      clusters: [0, 1, 2, 3, 4, 5, 6].map((k) => get('--s' + k)), returns: get('--returns'), noise: get('--noise'),
      classes: Object.fromEntries(CLASSES.map((name) => [name, get('--' + name)])),
    };
  };
  const colourOf = (colours, name) => colours.classes[name] || colours.muted;

  const corners = (b) => {
    const c = Math.cos(b.heading), s = Math.sin(b.heading), l = b.length / 2, w = b.width / 2;
    return [[l, w], [-l, w], [-l, -w], [l, -w]].map(([u, v]) => [b.x + c * u - s * v, b.y + s * u + c * v]);
  };
  const trace = (g, points) => {
    g.beginPath();
    points.forEach((p, i) => i ? g.lineTo(p[0], p[1]) : g.moveTo(p[0], p[1]));
  };
  const outline = (g, to, points) => {
    trace(g, points.map(([x, y]) => to(x, y)));
    g.closePath();
  };
  const line = (g, p, q, width, dash) => {
    g.lineWidth = width;
    g.setLineDash(dash || []);
    trace(g, [p, q]);
    g.stroke();
    g.setLineDash([]);
  };

  // The four sides of a box: from corner i to the next; whether the sensor sees it from outside.
  const sidesOf = (b, sensor) => {
    const c = Math.cos(b.heading), s = Math.sin(b.heading), dx = sensor[0] - b.x, dy = sensor[1] - b.y;
    const u = c * dx + s * dy, v = c * dy - s * dx;
    const seen = [v > b.width / 2, u < -b.length / 2, v < -b.width / 2, u > b.length / 2];
    return seen.map((is, i) => ({from: i, to: (i + 1) % 4, seen: is}));
  };
  // The corner farthest to the left (+1) or right (-1) as the sensor sees the box.
  const endCorner = (b, points, sensor, side) => {
    const angle = ([x, y]) => {
      const a = Math.atan2(y - sensor[1], x - sensor[0]) - Math.atan2(b.y - sensor[1], b.x - sensor[0]);
      return side * Math.atan2(Math.sin(a), Math.cos(a));
    };
    return points.reduce((best, p, i) => (angle(p) > angle(points[best]) ? i : best), 0);
  };

  // Sides turned to the sensor are thick; at a hidden end their outer half is dashed.
  const box = (g, to, t, sensor, width) => {
    const points = corners(t), on = points.map(([x, y]) => to(x, y));
    const hidden = [];
    if (t.hidden & 1) hidden.push(endCorner(t, points, sensor, 1));
    if (t.hidden & 2) hidden.push(endCorner(t, points, sensor, -1));
    for (const side of sidesOf(t, sensor)) {
      const p = on[side.from], q = on[side.to], m = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
      if (!side.seen) { line(g, p, q, 1); continue; }
      for (const [corner, at] of [[side.from, p], [side.to, q]]) {
        line(g, m, at, width, hidden.includes(corner) ? [4, 4] : []);
      }
    }
  };

  // One second of its way.
  const arrow = (g, to, t) => {
    const speed = Math.hypot(t.vx, t.vy);
    if (!(speed > 0.3)) return;
    const cut = Math.min(1, FASTEST / speed), p = to(t.x, t.y), q = to(t.x + cut * t.vx, t.y + cut * t.vy);
    const long = Math.hypot(q[0] - p[0], q[1] - p[1]);
    if (long < 6) return;
    const ux = (q[0] - p[0]) / long, uy = (q[1] - p[1]) / long, back = [q[0] - 8 * ux, q[1] - 8 * uy];
    line(g, p, back, 1.8);
    trace(g, [q, [back[0] - 3.5 * uy, back[1] + 3.5 * ux], [back[0] + 3.5 * uy, back[1] - 3.5 * ux]]);
    g.closePath();
    g.fill();
  };

  const ellipse = (g, to, t) => {
    const mean = (t.pxx + t.pyy) / 2, spread = Math.hypot((t.pxx - t.pyy) / 2, t.pxy);
    const a = 2 * Math.sqrt(Math.max(0, mean + spread)), b = 2 * Math.sqrt(Math.max(0, mean - spread));
    if (!(a < 50)) return;
    const angle = 0.5 * Math.atan2(2 * t.pxy, t.pxx - t.pyy), c = Math.cos(angle), s = Math.sin(angle);
    const ring = [];
    for (let k = 0; k < 32; k++) {
      const u = a * Math.cos(k * Math.PI / 16), v = b * Math.sin(k * Math.PI / 16);
      ring.push([t.x + c * u - s * v, t.y + s * u + c * v]);
    }
    outline(g, to, ring);
    g.globalAlpha *= 0.18;
    g.fill();
    g.globalAlpha /= 0.18;
    g.lineWidth = 1;
    g.stroke();
  };

  // Texts beside their boxes that do not cover one another: what finds no place is left out.
  const labeller = (g, colours, ego) => {
    const taken = [{x: ego[0] - 10, y: ego[1] - 14, w: 20, h: 28}];
    const free = (r) => taken.every((o) => r.x + r.w < o.x || o.x + o.w < r.x || r.y + r.h < o.y || o.y + o.h < r.y);
    return (text, p, reach, must) => {
      g.font = (must ? '600 ' : '') + '12px system-ui, sans-serif';
      const w = g.measureText(text).width + 6, h = 15;
      const places = [[p[0] + reach, p[1] - h / 2], [p[0] - reach - w, p[1] - h / 2],
        [p[0] - w / 2, p[1] - reach - h], [p[0] - w / 2, p[1] + reach]].map(([x, y]) => ({x, y, w, h}));
      const place = places.find(free) || (must ? places[0] : null);
      if (!place) return;
      taken.push(place);
      const alpha = g.globalAlpha;
      g.globalAlpha = 0.75;
      g.fillStyle = colours.card;
      g.fillRect(place.x, place.y, w, h);
      g.globalAlpha = alpha;
      g.fillStyle = colours.ink;
      g.fillText(text, place.x + 3, place.y + 11.5);
    };
  };

  return {TENTATIVE, COASTING, CLASSES, readColours, colourOf, corners, outline, box, arrow, ellipse, labeller};
})();

// Which track lived when: a strip of how many there are by class, and one row a track.
const timeline = (frames) => {
  const ROW = 14, GUTTER = 58, COUNTS = 56, AXIS = 20, MOST = 40, RIGHT = 12;
  const last = frames.length - 1;
  const lives = new Map();
  frames.forEach((frame, i) => frame.k.forEach((t) => {
    if (!lives.has(t.id)) lives.set(t.id, {id: t.id, spans: [], frames: {}, confirmed: false});
    const life = lives.get(t.id), span = life.spans[life.spans.length - 1];
    life.confirmed = life.confirmed || t.status !== marks.TENTATIVE;
    life.frames[t.name] = (life.frames[t.name] || 0) + 1;
    if (span && span.status === t.status && span.name === t.name && span.to === i - 1) span.to = i;
    else life.spans.push({status: t.status, name: t.name, from: i, to: i});
  }));
  const size = (life) => Object.values(life.frames).reduce((n, k) => n + k, 0);
  const rank = (life) => {
    const name = Object.keys(life.frames).reduce((a, b) => (life.frames[b] > life.frames[a] ? b : a));
    return (marks.CLASSES.indexOf(name) + 5) % 5;
  };
  const confirmed = [...lives.values()].filter((l) => l.confirmed);
  const rows = [...confirmed].sort((a, b) => size(b) - size(a)).slice(0, MOST)
    .sort((a, b) => rank(a) - rank(b) || a.spans[0].from - b.spans[0].from || a.id - b.id);
  const counts = frames.map((f) => marks.CLASSES.map(
    (name) => f.k.filter((t) => t.name === name && t.status !== marks.TENTATIVE).length));
  const most = Math.max(1, ...counts.map((c) => c.reduce((a, b) => a + b, 0)));
  const x = (w, i) => GUTTER + (w - GUTTER - RIGHT) * i / Math.max(1, frames.length);
  const top = (k) => COUNTS + 8 + k * ROW;

  const drawCounts = (g, w, colours) => {
    const y = (n) => COUNTS - (COUNTS - 8) * n / most;
    counts.forEach((count, i) => {
      let below = 0;
      count.forEach((n, k) => {
        g.fillStyle = marks.colourOf(colours, marks.CLASSES[k]);
        g.fillRect(x(w, i), y(below + n), x(w, i + 1) - x(w, i) + 0.5, y(below) - y(below + n));
        below += n;
      });
    });
    g.fillStyle = colours.muted;
    g.textAlign = 'right';
    g.fillText(most, GUTTER - 8, 14);
    g.fillText('0', GUTTER - 8, COUNTS);
  };
  const drawSpan = (g, span, x0, x1, y) => {
    if (span.status === marks.TENTATIVE) g.fillRect(x0, y + 5, x1 - x0, 2);
    else if (span.status === marks.COASTING) g.strokeRect(x0 + 0.5, y + 3.5, Math.max(1, x1 - x0 - 1), 5);
    else g.fillRect(x0, y + 2, x1 - x0, 8);
  };
  const drawRow = (g, w, colours, row, k, picked) => {
    const y = top(k), spans = row.spans, end = spans[spans.length - 1].to;
    g.fillStyle = picked ? colours.ink : colours.muted;
    g.textAlign = 'right';
    g.font = (picked ? '600 ' : '') + '12px system-ui, sans-serif';
    g.fillText(row.id, GUTTER - 8, y + 10);
    for (const span of spans) {
      g.strokeStyle = g.fillStyle = marks.colourOf(colours, span.name);
      g.lineWidth = 1;
      drawSpan(g, span, x(w, span.from), Math.max(x(w, span.from) + 1, x(w, span.to + 1)), y);
    }
    g.strokeStyle = colours.ink;
    g.lineWidth = 1.5;
    g.beginPath();
    const birth = x(w, spans[0].from);
    g.moveTo(birth, y + 1);
    g.lineTo(birth, y + 11);
    if (end < last) {
      const death = x(w, end + 1) + 5;
      for (const s of [-1, 1]) { g.moveTo(death - 3, y + 6 - 3 * s); g.lineTo(death + 3, y + 6 + 3 * s); }
    }
    g.stroke();
  };
  const drawAxis = (g, w, h, colours) => {
    const span = frames.length ? frames[last].t - frames[0].t : 0;
    const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].find((s) => span / s <= 12) || 5000;
    g.font = '12px system-ui, sans-serif';
    g.textAlign = 'center';
    g.fillStyle = colours.muted;
    let next = 0;
    frames.forEach((f, i) => {
      if (f.t < next - 1e-6) return;
      g.fillText(next.toFixed(step < 1 ? 1 : 0) + ' s', x(w, i), h - 4);
      next += step * Math.max(1, Math.floor((f.t - next) / step) + 1);
    });
  };
  return {
    rows, confirmed: confirmed.length, height: top(rows.length) + AXIS,
    frameAt: (w, px) => Math.floor((px - GUTTER) / (w - GUTTER - RIGHT) * frames.length),
    rowAt: (py) => rows[Math.floor((py - top(0)) / ROW)],
    draw: (g, w, h, colours, at, picked) => {
      g.clearRect(0, 0, w, h);
      g.font = '12px system-ui, sans-serif';
      drawCounts(g, w, colours);
      rows.forEach((row, k) => drawRow(g, w, colours, row, k, row.id === picked));
      drawAxis(g, w, h, colours);
      g.textAlign = 'left';
      g.fillStyle = colours.ink;
      g.fillRect(x(w, at), 0, 1.5, h - AXIS + 2);
    },
  };
};
