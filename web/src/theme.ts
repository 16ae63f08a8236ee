import { PALETTES, type ThemeName } from "./palette";

/** Hands the palette to the style sheet, whose colours are all variables. */
export function applyTheme(theme: ThemeName): void {
  const root = document.documentElement;
  root.dataset["theme"] = theme;
  const palette = PALETTES[theme];
  for (const [name, value] of Object.entries(palette)) {
    if (typeof value === "string") root.style.setProperty(`--${name}`, value);
  }
  palette.classes.forEach((value, i) => root.style.setProperty(`--class-${i}`, value));
}
