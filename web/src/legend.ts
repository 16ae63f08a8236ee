import { fill, h } from "./dom";
import { PALETTES, ramp } from "./palette";
import type { Frame } from "./protocol";
import type { Settings } from "./settings";

/** In a corner of the scene: what the colours mean. */
export class Legend {
  readonly element = h("div", { class: "legend" });

  constructor(private readonly settings: Settings, private readonly classes: () => string[]) {}

  draw(frame: Frame | null): void {
    const palette = PALETTES[this.settings.theme];
    const present = new Set((frame?.tracks ?? []).map((t) => t.class));
    const items: HTMLElement[] = [];
    this.classes().forEach((name, i) => {
      if (present.has(i)) items.push(swatch(palette.classes[i] ?? "", name));
    });
    if ((frame?.tracks ?? []).some((t) => t.status === 2)) items.push(h("span", {}, "pale: not seen now"));
    if ((frame?.truth.length ?? 0) > 0) items.push(swatch(palette.truth, "truth (dashed)"));
    fill(this.element, h("span", { class: "hint" }, this.pointsText(frame)), ...this.scale(frame), ...items);
  }

  private pointsText(frame: Frame | null): string {
    if (frame && frame.rays.length > 0) return raysText(frame);
    if (frame && frame.edges.length > 0 && this.settings.colourBy === "segment") {
      return `${frame.clusters.length.toLocaleString("en")} returns shown; coloured: those of this position`;
    }
    const count = (frame?.clusters.length ?? 0).toLocaleString("en");
    const by = this.settings.colourBy;
    return by === "segment"
      ? `${count} returns; a colour for each segment, grey in none`
      : `${count} returns by ${by}`;
  }

  private scale(frame: Frame | null): HTMLElement[] {
    const ends: Partial<Record<string, [string, string]>> = {
      intensity: [(frame?.intensityLow ?? 0).toPrecision(3), (frame?.intensityHigh ?? 0).toPrecision(3)],
      layer: ["lowest", "highest"],
      height: ["2 m below the sensor", "2 m above"],
      age: ["oldest", "newest"],
    };
    const pair = ends[this.settings.colourBy];
    if (!pair) return [];
    const bar = h("canvas", { width: "96", height: "10" });
    const pen = bar.getContext("2d");
    for (let x = 0; pen && x < 96; ++x) {
      pen.fillStyle = `rgb(${ramp(x / 95, this.settings.theme).join(",")})`;
      pen.fillRect(x, 0, 1, 10);
    }
    return [h("span", { class: "ramp" }, pair[0], bar, pair[1])];
  }
}

function swatch(colour: string, text: string): HTMLElement {
  const mark = h("i", { class: "swatch" });
  mark.style.backgroundColor = colour;
  return h("span", {}, mark, text);
}

/** Of sensors that tell directions only. */
function raysText(frame: Frame): string {
  const aimed = frame.rays.filter((ray) => ray.target >= 0).length;
  const ends = frame.tracks.length === 0 ? "positions found, each with its 95 % ellipse" : "targets";
  return `${frame.rays.length} bearings: ${aimed} blue to ${ends}, ${frame.rays.length - aimed} grey to none`;
}
