import { h } from "../dom";
import type { Option } from "../messages";

/** The number typed must lie in "low .. high". */
export function bounds(range: string): [number, number] | null {
  const match = /^(\S+) \.\. (\S+)$/.exec(range);
  if (!match) return null;
  const low = Number(match[1]);
  const high = Number(match[2]);
  return Number.isFinite(low) && Number.isFinite(high) ? [low, high] : null;
}

/** A form of every option of the library; tells which were changed. */
export class OptionsForm {
  readonly element = h("div", { class: "options" });
  private readonly filter = h("input", { type: "search", placeholder: "Find an option", "aria-label": "Find an option" });
  private readonly list = h("div");
  private options: Option[] = [];
  private readonly values = new Map<string, string>();

  constructor(private readonly changed: () => void) {
    this.filter.addEventListener("input", () => this.applyFilter());
    this.element.append(this.filter, this.list);
  }

  show(options: Option[]): void {
    this.options = options;
    this.values.clear();
    this.draw();
  }

  /** "section.name=value" of every option that differs from what the server gave. */
  get changes(): string[] {
    return [...this.values].map(([key, value]) => `${key}=${value}`);
  }

  reset(): void {
    this.values.clear();
    this.draw();
  }

  private draw(): void {
    const sections = new Map<string, Option[]>();
    for (const option of this.options) {
      sections.set(option.section, [...(sections.get(option.section) ?? []), option]);
    }
    this.list.replaceChildren(...[...sections].map(([name, options]) => {
      const body = h("details", { "data-section": name }, h("summary", {}, name));
      for (const option of options) body.append(this.row(option));
      return body;
    }));
    this.applyFilter();
  }

  private row(option: Option): HTMLElement {
    const key = `${option.section}.${option.name}`;
    const id = `option-${key}`;
    const field = this.field(option, id);
    const row = h("div", { class: "option", "data-key": key },
      h("label", { for: id, title: option.doc }, option.name),
      field,
      h("p", { class: "hint" }, `${option.doc}. Range: ${option.range || "any text"}; default ${option.fallback}.`));
    row.classList.toggle("differs", option.value !== option.fallback);
    field.addEventListener("change", () => this.take(option, key, row, field));
    return row;
  }

  private take(option: Option, key: string, row: HTMLElement, field: HTMLInputElement | HTMLSelectElement): void {
    const value = field instanceof HTMLInputElement && field.type === "checkbox" ? String(field.checked) : field.value.trim();
    const limits = bounds(option.range);
    const number = Number(value);
    const bad = limits !== null && !(value !== "" && number >= limits[0] && number <= limits[1]);
    field.setAttribute("aria-invalid", String(bad));
    if (bad) return;
    if (value === option.value) this.values.delete(key);
    else this.values.set(key, value);
    row.classList.toggle("changed", this.values.has(key));
    this.changed();
  }

  private field(option: Option, id: string): HTMLInputElement | HTMLSelectElement {
    if (option.range === "true | false") {
      return h("input", { id, type: "checkbox", checked: option.value === "true" });
    }
    if (option.range.includes(" | ")) {
      const select = h("select", { id });
      for (const value of option.range.split(" | ")) {
        select.append(h("option", { value, selected: value === option.value }, value));
      }
      return select;
    }
    return h("input", { id, type: "text", inputmode: bounds(option.range) ? "decimal" : "text", value: option.value, autocomplete: "off" });
  }

  private applyFilter(): void {
    const wanted = this.filter.value.trim().toLowerCase();
    for (const section of this.list.querySelectorAll("details")) {
      let any = false;
      for (const row of section.querySelectorAll<HTMLElement>(".option")) {
        const fits = wanted === "" || (row.textContent ?? "").toLowerCase().includes(wanted) ||
          (row.dataset["key"] ?? "").includes(wanted);
        row.hidden = !fits;
        any ||= fits;
      }
      section.hidden = !any;
      if (wanted !== "") section.open = any;
    }
  }
}
