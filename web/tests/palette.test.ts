import { describe, expect, it } from "vitest";

import { contrast, PALETTES, SEGMENT_COLOURS, type ThemeName } from "../src/palette";

const THEMES: ThemeName[] = ["dark", "light"];

describe("contrast", () => {
  it("is 21 between black and white and 1 of a colour with itself", () => {
    expect(contrast("#000000", "#ffffff")).toBeCloseTo(21, 5);
    expect(contrast("#56b4e9", "#56b4e9")).toBeCloseTo(1, 10);
  });
});

describe.each(THEMES)("the %s palette", (theme) => {
  const palette = PALETTES[theme];
  const grounds = [palette.ground, palette.panel, palette.raised];

  it("gives all text the 4.5 of WCAG AA on every ground", () => {
    for (const ground of grounds) {
      for (const text of [palette.text, palette.faint, palette.warning]) {
        expect(contrast(text, ground), `${text} on ${ground}`).toBeGreaterThanOrEqual(4.5);
      }
    }
    expect(contrast(palette.onAccent, palette.accent)).toBeGreaterThanOrEqual(4.5);
  });

  it("gives names in the scene 4.5, since they are coloured by class", () => {
    for (const colour of [...palette.classes, palette.selected]) {
      expect(contrast(colour, palette.ground), colour).toBeGreaterThanOrEqual(4.5);
    }
  });

  it("gives graphics the 3 of WCAG AA", () => {
    const graphics = [...palette.events, palette.truth, palette.accent, palette.noise, ...SEGMENT_COLOURS[theme]];
    for (const colour of graphics) {
      expect(contrast(colour, palette.ground), colour).toBeGreaterThanOrEqual(3);
    }
  });

  it("tells classes apart without red-green vision", () => {
    for (const see of [deuteranope, protanope]) {
      palette.classes.forEach((a, i) => {
        palette.classes.slice(i + 1).forEach((b) => {
          expect(distance(see(a), see(b)), `${a} and ${b}`).toBeGreaterThan(15);
        });
      });
    }
  });
});

/** What is left of a colour without one kind of cones; linear RGB, Machado et al. 2009, severity 1. */
function seen(hex: string, m: number[][]): number[] {
  const value = parseInt(hex.slice(1), 16);
  const linear = [value >> 16, (value >> 8) & 255, value & 255].map((b) =>
    b / 255 <= 0.04045 ? b / 255 / 12.92 : ((b / 255 + 0.055) / 1.055) ** 2.4);
  return m.map((row) => row.reduce((sum, k, i) => sum + k * (linear[i] ?? 0), 0));
}
const deuteranope = (hex: string) => seen(hex, [
  [0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881],
]);
const protanope = (hex: string) => seen(hex, [
  [0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998],
]);

/** Of two linear RGB colours in CIELAB. */
function distance(a: number[], b: number[]): number {
  const lab = ([r = 0, g = 0, bl = 0]: number[]) => {
    const f = (t: number) => (t > 0.008856 ? Math.cbrt(Math.max(t, 0)) : 7.787 * t + 16 / 116);
    const x = f((0.4124 * r + 0.3576 * g + 0.1805 * bl) / 0.9505);
    const y = f(0.2126 * r + 0.7152 * g + 0.0722 * bl);
    const z = f((0.0193 * r + 0.1192 * g + 0.9505 * bl) / 1.089);
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
  };
  const [p, q] = [lab(a), lab(b)];
  return Math.hypot(...p.map((v, i) => v - (q[i] ?? 0)));
}
