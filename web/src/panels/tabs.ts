import { h } from "../dom";

/** The side of the page: one panel at a time. */
export class Tabs {
  readonly element = h("aside", { class: "side" });
  private readonly buttons = new Map<string, HTMLButtonElement>();

  constructor(private readonly panels: [string, HTMLElement][], private readonly opened: (name: string) => void) {
    const list = h("div", { class: "tabs", role: "tablist" });
    for (const [name, panel] of panels) {
      const id = `panel-${name.toLowerCase()}`;
      panel.id = id;
      panel.setAttribute("role", "tabpanel");
      const tab = h("button", { type: "button", role: "tab", "aria-controls": id, onclick: () => this.open(name) }, name);
      this.buttons.set(name, tab);
      list.append(tab);
    }
    this.element.append(list, ...panels.map(([, panel]) => panel));
    this.mark(panels[0]?.[0] ?? "");
  }

  open(name: string): void {
    this.mark(name);
    this.opened(name);
  }

  private mark(name: string): void {
    for (const [other, panel] of this.panels) panel.hidden = other !== name;
    for (const [other, tab] of this.buttons) tab.setAttribute("aria-selected", String(other === name));
  }
}
