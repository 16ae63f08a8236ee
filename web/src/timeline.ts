import { clock, h } from "./dom";
import { PALETTES } from "./palette";
import type { Player } from "./player";
import { EVENT_NAMES, type TrackEvent } from "./protocol";
import type { Settings } from "./settings";

const ROW = 11;
const TOP = 8;
const GUTTER = 52; // for the names of the rows
const MOST_PER_ROW = 400;

/** The bar below the scene: where we are, the events of all tracks, the life of the selected one. */
export class Timeline {
  readonly element = h("div", { class: "timeline", role: "slider", tabindex: "0", "aria-label": "Time", "aria-valuemin": "0" });
  events: TrackEvent[] = [];
  /** First and last frame of the selected track. */
  life: [number, number] | null = null;
  /** Frames that a trial covers. */
  trial: [number, number] | null = null;
  private readonly canvas = h("canvas");
  private readonly tip = h("div", { class: "tip", role: "status" });

  constructor(private readonly player: Player, private readonly settings: Settings) {
    this.element.append(this.canvas, this.tip);
    this.tip.hidden = true;
    new ResizeObserver(() => this.draw()).observe(this.element);
    player.changed.on(() => this.draw());
    player.moved.on(() => this.draw());
    this.listen();
  }

  draw(): void {
    const ratio = window.devicePixelRatio;
    const width = this.element.clientWidth;
    const height = this.element.clientHeight;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    const pen = this.canvas.getContext("2d");
    if (!pen) return;
    pen.scale(ratio, ratio);
    const palette = PALETTES[this.settings.theme];
    pen.clearRect(0, 0, width, height);
    if (this.trial) this.bar(pen, this.trial, height - 6, 5, palette.warning);
    if (this.life) this.bar(pen, this.life, TOP + 4 * ROW + 2, 4, palette.selected);
    this.drawEvents(pen, palette.events);
    this.drawTicks(pen, width, height, palette.faint);
    pen.fillStyle = palette.accent;
    const x = this.xOf(this.player.frame);
    pen.fillRect(x - 1, 0, 2, height);
    this.element.setAttribute("aria-valuemax", String(Math.max(0, this.player.count - 1)));
    this.element.setAttribute("aria-valuenow", String(this.player.frame));
    this.element.setAttribute("aria-valuetext", clock(this.player.time));
  }

  /** The nearest event before or after the frame shown. */
  nextEvent(direction: 1 | -1): TrackEvent | null {
    const ahead = this.events.filter((e) => direction * (e.frame - this.player.frame) > 0);
    ahead.sort((a, b) => direction * (a.frame - b.frame));
    return ahead[0] ?? null;
  }

  private xOf(frame: number): number {
    return this.xAt(this.player.timeOf(frame));
  }

  private xAt(time: number): number {
    const width = this.element.clientWidth - GUTTER - 6;
    return GUTTER + (time / Math.max(1e-9, this.player.duration)) * width;
  }

  private bar(pen: CanvasRenderingContext2D, [from, to]: [number, number], y: number, thick: number, colour: string): void {
    pen.fillStyle = colour;
    const x = this.xOf(from);
    pen.fillRect(x, y, Math.max(2, this.xOf(to) - x), thick);
  }

  /** A row and a sign for each kind; at most one mark a pixel, so that an hour stays quick. */
  private drawEvents(pen: CanvasRenderingContext2D, colours: readonly string[]): void {
    const marked = EVENT_NAMES.map(() => new Set<number>());
    for (const event of this.events) {
      const row = marked[event.kind];
      if (!row || row.size > MOST_PER_ROW * 4) continue;
      row.add(Math.round(this.xOf(event.frame)));
    }
    marked.forEach((row, kind) => {
      pen.fillStyle = colours[kind] ?? "#888888";
      const y = TOP + kind * ROW;
      pen.font = "11px system-ui, sans-serif";
      pen.fillText(EVENT_NAMES[kind] ?? "", 6, y + 3);
      for (const x of row) sign(pen, kind, x, y);
    });
  }

  private drawTicks(pen: CanvasRenderingContext2D, width: number, height: number, colour: string): void {
    const duration = this.player.duration;
    const steps = [0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1800, 3600];
    const step = steps.find((s) => (s / Math.max(duration, 1e-9)) * width > 70) ?? 7200;
    pen.fillStyle = colour;
    pen.font = "11px system-ui, sans-serif";
    for (let t = 0; t <= duration; t += step) {
      const x = this.xAt(t);
      pen.fillRect(x, height - 16, 1, 4);
      if (x < width - 40) pen.fillText(clock(t).replace(/\.0$/, ""), x + 3, height - 8);
    }
  }

  private listen(): void {
    let dragging = false;
    const frameAt = (event: PointerEvent) => {
      const box = this.element.getBoundingClientRect();
      const share = (event.clientX - box.left - GUTTER) / Math.max(1, box.width - GUTTER - 6);
      return this.player.frameAt(share * this.player.duration);
    };
    this.element.addEventListener("pointerdown", (event) => {
      dragging = true;
      this.element.setPointerCapture(event.pointerId);
      this.player.seek(frameAt(event));
    });
    this.element.addEventListener("pointermove", (event) => {
      if (dragging) this.player.seek(frameAt(event));
      this.showTip(event, frameAt(event));
    });
    this.element.addEventListener("pointerup", () => (dragging = false));
    this.element.addEventListener("pointerleave", () => (this.tip.hidden = true));
  }

  private showTip(event: PointerEvent, frame: number): void {
    const box = this.element.getBoundingClientRect();
    const x = event.clientX - box.left;
    const near = this.events.filter((e) => Math.abs(this.xOf(e.frame) - x) < 4).slice(0, 4);
    const names = near.map((e) => `${EVENT_NAMES[e.kind] ?? ""} of ${e.track}`);
    this.tip.textContent = [clock(this.player.timeOf(frame)), ...names].join(", ");
    this.tip.hidden = false;
    const left = Math.min(x, box.width - this.tip.offsetWidth - 4);
    this.tip.style.transform = `translateX(${left.toFixed(0)}px)`;
  }
}

/** Birth points up, coasting is a dash, loss a cross, a switch a ring: told apart without colour. */
function sign(pen: CanvasRenderingContext2D, kind: number, x: number, y: number): void {
  const r = 3.5;
  pen.beginPath();
  if (kind === 0) {
    pen.moveTo(x, y - r);
    pen.lineTo(x + r, y + r);
    pen.lineTo(x - r, y + r);
    pen.fill();
  } else if (kind === 1) {
    pen.fillRect(x - r, y - 1, 2 * r, 2.5);
  } else if (kind === 2) {
    pen.strokeStyle = pen.fillStyle;
    pen.lineWidth = 1.6;
    pen.moveTo(x - r, y - r);
    pen.lineTo(x + r, y + r);
    pen.moveTo(x + r, y - r);
    pen.lineTo(x - r, y + r);
    pen.stroke();
  } else {
    pen.strokeStyle = pen.fillStyle;
    pen.lineWidth = 2;
    pen.arc(x, y, r, 0, 2 * Math.PI);
    pen.stroke();
  }
}
