// Colours that colour-blind people tell apart [Okabe2008], in a shade for dark and one for light
// ground. tests/palette.test.ts holds every text to the contrast of WCAG AA.

export type ThemeName = "dark" | "light";

export interface Palette {
  ground: string;
  panel: string;
  raised: string;
  edge: string;
  text: string;
  faint: string;
  accent: string;
  onAccent: string;
  warning: string;
  grid: string;
  noise: string;
  truth: string;
  selected: string;
  /** By class: unknown, vehicle, pedestrian, cyclist, other. */
  classes: [string, string, string, string, string];
  /** By kind: birth, coast, loss, switch. */
  events: [string, string, string, string];
}

export const PALETTES: Record<ThemeName, Palette> = {
  dark: {
    ground: "#10151c",
    panel: "#18202a",
    raised: "#232e3b",
    edge: "#3a4858",
    text: "#edf2f7",
    faint: "#a9b7c6",
    accent: "#56b4e9",
    onAccent: "#0b1016",
    warning: "#f0b429",
    grid: "#2a3543",
    noise: "#7d8b99",
    truth: "#f2f2f2",
    selected: "#f0e442",
    classes: ["#dfe6ee", "#56b4e9", "#e69f00", "#1fa37c", "#c86fa3"],
    events: ["#2fc79a", "#e69f00", "#ff7a52", "#d98cb8"],
  },
  light: {
    ground: "#f7f9fb",
    panel: "#ffffff",
    raised: "#e9eef3",
    edge: "#a5b1be",
    text: "#16202b",
    faint: "#48596a",
    accent: "#0064a0",
    onAccent: "#ffffff",
    warning: "#8a5300",
    grid: "#d5dde5",
    noise: "#7a8794",
    truth: "#303030",
    selected: "#7a5f00",
    classes: ["#1f2730", "#0064a0", "#a35c00", "#00704f", "#8f2f6b"],
    events: ["#00704f", "#9c5700", "#b83b00", "#96406f"],
  },
};

/** Twelve colours for segments, in turn; neighbours differ in lightness too. */
export const SEGMENT_COLOURS: Record<ThemeName, string[]> = {
  dark: [
    "#56b4e9", "#e69f00", "#2fc79a", "#f0e442", "#d98cb8", "#ff7a52",
    "#9fd3f4", "#ffd27a", "#8fe3c8", "#b3a5ff", "#f3bfd9", "#c9d65b",
  ],
  light: [
    "#0064a0", "#b06000", "#007a57", "#6b5b00", "#96406f", "#b83b00",
    "#3f7fae", "#8a4b1f", "#2f6f5c", "#5a48b0", "#a85a86", "#5f6b00",
  ],
};

/** Low to high, readable without colour vision: from blue over grey to yellow. */
export function ramp(share: number, theme: ThemeName): [number, number, number] {
  const t = Math.max(0, Math.min(1, share));
  const stops = theme === "dark"
    ? [[0x3b, 0x6f, 0xd4], [0x9a, 0xa4, 0xad], [0xf6, 0xe0, 0x4a]]
    : [[0x1f, 0x3f, 0x9c], [0x6f, 0x77, 0x80], [0xa0, 0x7b, 0x00]];
  const part = t < 0.5 ? 0 : 1;
  const low = stops[part] as number[];
  const high = stops[part + 1] as number[];
  const within = 2 * t - part;
  return [0, 1, 2].map((i) =>
    Math.round((low[i] ?? 0) + within * ((high[i] ?? 0) - (low[i] ?? 0))),
  ) as [number, number, number];
}

export function rgb(hex: string): [number, number, number] {
  const value = parseInt(hex.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/** Contrast of two colours as WCAG 2.2 defines it, 1 to 21. */
export function contrast(a: string, b: string): number {
  const [low, high] = [luminance(a), luminance(b)].sort((p, q) => p - q) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

function luminance(hex: string): number {
  const [r, g, b] = rgb(hex).map((byte) => {
    const share = byte / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
