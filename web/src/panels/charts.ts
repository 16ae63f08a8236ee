import uPlot from "uplot";

import { h } from "../dom";
import { PALETTES, type ThemeName } from "../palette";
import type { HistorySample } from "../protocol";

/** Two-sided 95 % band of chi-square with two degrees of freedom. */
export const NIS_BAND: readonly [number, number] = [0.0506, 7.378];

interface Curve {
  label: string;
  of: (sample: HistorySample) => number | null;
  band?: readonly [number, number];
}

interface ChartSpec {
  title: string;
  curves: Curve[];
}

const CHARTS: ChartSpec[] = [
  { title: "Position / m", curves: [{ label: "x", of: (s) => s.x }, { label: "y", of: (s) => s.y }] },
  {
    title: "Speed / (m/s)",
    curves: [
      { label: "speed", of: (s) => s.speed },
      { label: "vx", of: (s) => s.vx },
      { label: "vy", of: (s) => s.vy },
    ],
  },
  {
    title: "Innovation (NIS), 95 % band shaded",
    curves: [{ label: "NIS", of: (s) => (s.detection >= 0 ? Math.min(s.nis, 25) : null), band: NIS_BAND }],
  },
  {
    title: "Probability",
    curves: [
      { label: "of its class", of: (s) => s.classProbability },
      { label: "that it moves", of: (s) => s.movingProbability },
    ],
  },
];

/** The curves of one track over time, with the time shown as a line; a click goes there. */
export class Charts {
  readonly element = h("div", { class: "charts" });
  private plots: uPlot[] = [];
  private time = 0;

  constructor(private readonly goTo: (time: number) => void) {}

  show(samples: HistorySample[], theme: ThemeName): void {
    this.clear();
    const width = Math.max(200, this.element.clientWidth || 300);
    for (const spec of CHARTS) {
      const data = [samples.map((s) => s.time), ...spec.curves.map((c) => samples.map(c.of))];
      const plot = new uPlot(this.options(spec, theme, width), data as uPlot.AlignedData, this.element);
      plot.over.addEventListener("click", () => {
        const time = plot.posToVal(plot.cursor.left ?? 0, "x");
        if (Number.isFinite(time)) this.goTo(time);
      });
      this.plots.push(plot);
    }
  }

  setTime(time: number): void {
    this.time = time;
    for (const plot of this.plots) plot.redraw(false, false);
  }

  clear(): void {
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    this.element.replaceChildren();
  }

  private options(spec: ChartSpec, theme: ThemeName, width: number): uPlot.Options {
    const palette = PALETTES[theme];
    const colours = [palette.accent, palette.events[1], palette.events[0]];
    const axis = { stroke: palette.faint, grid: { stroke: palette.grid, width: 1 }, ticks: { stroke: palette.grid } };
    return {
      title: spec.title,
      width,
      height: 130,
      cursor: { sync: { key: "track" }, drag: { x: false, y: false } },
      legend: { live: true },
      scales: { x: { time: false } },
      axes: [{ ...axis, size: 26 }, { ...axis, size: 46 }],
      series: [
        { label: "t / s", value: (_, v) => (v === null ? "" : v.toFixed(2)) },
        ...spec.curves.map((curve, i) => ({
          label: curve.label,
          stroke: colours[i] ?? palette.text,
          width: 1.5,
          dash: i === 0 ? [] : i === 1 ? [6, 3] : [2, 2],
          points: { show: false },
          value: (_: uPlot, v: number | null) => (v === null ? "" : v.toPrecision(4)),
        })),
      ],
      hooks: {
        drawAxes: [(plot) => spec.curves.forEach((c) => c.band && shade(plot, c.band, palette.raised))],
        draw: [(plot) => mark(plot, this.time, palette.text)],
      },
    };
  }
}

function shade(plot: uPlot, [low, high]: readonly [number, number], colour: string): void {
  const { left, width } = plot.bbox;
  const top = Math.max(plot.valToPos(high, "y", true), plot.bbox.top);
  const bottom = plot.valToPos(low, "y", true);
  plot.ctx.fillStyle = colour;
  plot.ctx.fillRect(left, top, width, bottom - top);
}

function mark(plot: uPlot, time: number, colour: string): void {
  const x = plot.valToPos(time, "x", true);
  if (!(x >= plot.bbox.left && x <= plot.bbox.left + plot.bbox.width)) return;
  plot.ctx.fillStyle = colour;
  plot.ctx.fillRect(x, plot.bbox.top, Math.max(1, window.devicePixelRatio), plot.bbox.height);
}
