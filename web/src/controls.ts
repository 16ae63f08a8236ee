import { button, choice, clock, h } from "./dom";
import type { Player } from "./player";
import { COLOUR_BY, type ColourBy, type Settings, SHOWN } from "./settings";

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8];

/** The row of buttons beside the timeline. */
export class Transport {
  readonly element = h("div", { class: "transport" });
  private readonly play: HTMLButtonElement;
  private readonly time = h("output", { class: "time" });
  private readonly speed: HTMLSelectElement;

  constructor(private readonly player: Player, jump: (direction: 1 | -1) => void) {
    this.play = button("▶", "Play (space)", () => player.toggle(), { class: "primary play" });
    this.speed = choice(SPEEDS.map((s) => `${s} x`), "1 x", "Speed", (text) =>
      player.setSpeed(parseFloat(text)));
    this.element.append(
      button("‹ event", "Event before ([)", () => jump(-1)),
      button("-1", "Frame back (left)", () => player.step(-1)),
      this.play,
      button("+1", "Frame on (right)", () => player.step(1)),
      button("event ›", "Event after (])", () => jump(1)),
      this.speed, this.time);
    player.changed.on(() => this.draw());
    player.moved.on(() => this.draw());
    this.draw();
  }

  private draw(): void {
    const { playing, time, duration, frame, count, speed } = this.player;
    this.play.textContent = playing ? "❚❚" : "▶";
    this.play.setAttribute("aria-label", playing ? "Pause (space)" : "Play (space)");
    this.play.title = playing ? "Pause (space)" : "Play (space)";
    this.speed.value = `${speed} x`;
    this.time.textContent = `${clock(time)} / ${clock(duration)}   frame ${Math.min(frame + 1, count)} of ${count}`;
  }
}

/** The bar above the scene: how it is shown. */
export class TopBar {
  readonly element = h("header", { class: "topbar" });
  private readonly title = h("strong", { class: "title" });
  private readonly note = h("span", { class: "note", role: "status" });
  private readonly view: HTMLButtonElement;
  private readonly colour: HTMLSelectElement;
  private readonly follow: HTMLButtonElement;

  constructor(private readonly settings: Settings, help: () => void, fit: () => void) {
    this.view = button("Top view", "Top view or in space (v)", () =>
      settings.change((s) => (s.view = s.view === "top" ? "3d" : "top")));
    this.colour = choice(COLOUR_BY, settings.colourBy, "Colour of the returns (c)", (value) =>
      settings.change((s) => (s.colourBy = value as ColourBy)));
    this.follow = button("Follow", "Move along with the vehicle or the selected track (f)", () =>
      settings.change((s) => (s.follow = !s.follow)));
    this.element.append(
      this.title, this.note,
      this.view,
      h("label", { class: "inline" }, "Colour by", this.colour),
      this.layers(),
      this.follow,
      button("Fit", "Look at everything, or at the selected track (0)", fit),
      button("◐", "Dark or light (t)", () =>
        settings.change((s) => (s.theme = s.theme === "dark" ? "light" : "dark"))),
      button("?", "Help (h)", help));
    settings.changed.on(() => this.draw());
    this.draw();
  }

  setTitle(text: string): void {
    this.title.textContent = text;
    document.title = `${text} - scanfuse`;
  }

  setNote(text: string, isWarning = false): void {
    this.note.textContent = text;
    this.note.classList.toggle("warning", isWarning);
  }

  /** A list of what is shown, behind a button. */
  private layers(): HTMLElement {
    const body = h("div", { class: "menu" });
    for (const [name, says] of SHOWN) {
      const box = h("input", { type: "checkbox", checked: this.settings.shown[name] });
      box.addEventListener("change", () => this.settings.change((s) => (s.shown[name] = box.checked)));
      this.settings.changed.on(() => (box.checked = this.settings.shown[name]));
      body.append(h("label", {}, box, says));
    }
    const kept = h("input", { type: "range", min: "1", max: "30", value: "1", "aria-label": "Scans kept" });
    kept.addEventListener("input", () => this.settings.change((s) => (s.scansKept = Number(kept.value))));
    const size = h("input", { type: "range", min: "1", max: "8", value: String(this.settings.pointSize), "aria-label": "Size of returns" });
    size.addEventListener("input", () => this.settings.change((s) => (s.pointSize = Number(size.value))));
    body.append(h("label", {}, "Scans kept", kept), h("label", {}, "Size of returns", size));
    return h("details", { class: "layers" }, h("summary", {}, "Show"), body);
  }

  private draw(): void {
    const { view, colourBy, follow } = this.settings;
    this.view.textContent = view === "top" ? "In space" : "Top view";
    this.colour.value = colourBy;
    this.follow.setAttribute("aria-pressed", String(follow));
  }
}
