import type { ThemeName } from "./palette";
import { Signal } from "./signal";

export const COLOUR_BY = ["segment", "class", "intensity", "layer", "age", "height"] as const;
export type ColourBy = (typeof COLOUR_BY)[number];

export const SHOWN = [
  ["points", "Returns"],
  ["outlines", "Outlines"],
  ["boxes", "Tracks"],
  ["ids", "Names"],
  ["trails", "Trails"],
  ["covariance", "95 % ellipses"],
  ["detections", "Detections"],
  ["truth", "Truth"],
  ["sight", "Sensor and lines of sight"],
  ["tentative", "Tentative tracks"],
] as const;
export type Shown = (typeof SHOWN)[number][0];

/** What the user chose to look at, kept in the browser between visits. */
export class Settings {
  readonly changed = new Signal<void>();
  view: "top" | "3d" = "3d";
  colourBy: ColourBy = "segment";
  theme: ThemeName = "dark";
  follow = true;
  scansKept = 1;
  pointSize = 3;
  selected: number | null = null;
  compare = false;
  readonly shown: Record<Shown, boolean> = {
    points: true,
    outlines: true,
    boxes: true,
    ids: true,
    trails: true,
    covariance: false,
    detections: false,
    truth: true,
    sight: false,
    tentative: false,
  };

  constructor(private readonly storage: Storage | null) {
    this.load();
  }

  change(edit: (settings: Settings) => void): void {
    edit(this);
    this.save();
    this.changed.emit();
  }

  private load(): void {
    try {
      const kept = JSON.parse(this.storage?.getItem("scanfuse") ?? "{}") as Partial<Settings>;
      if (kept.view === "top" || kept.view === "3d") this.view = kept.view;
      if (kept.colourBy && COLOUR_BY.includes(kept.colourBy)) this.colourBy = kept.colourBy;
      if (kept.theme === "dark" || kept.theme === "light") this.theme = kept.theme;
      for (const [name] of SHOWN) {
        const value = kept.shown?.[name];
        if (typeof value === "boolean") this.shown[name] = value;
      }
    } catch {
      // Settings of another version, or none: the defaults are fine.
    }
  }

  private save(): void {
    const { view, colourBy, theme, shown } = this;
    try {
      this.storage?.setItem("scanfuse", JSON.stringify({ view, colourBy, theme, shown }));
    } catch {
      // A private window keeps nothing.
    }
  }
}
