import { choice, download, fill, h } from "../dom";
import type { Asked, LabelBox, LabelObject, LabelsReply } from "../messages";
import type { Settings } from "../settings";
import { contains } from "../view/geometry";

const DEGREES = 180 / Math.PI;
const CLASSES = ["vehicle", "pedestrian", "cyclist", "other", "unknown"];

/** Makes truth from tracks: accept, correct, class, merge, split, save. */
export class LabelPanel {
  readonly element = h("section", { class: "panel", "aria-label": "Label" });
  private readonly list = h("ul", { class: "tracks" });
  private readonly editor = h("div");
  private readonly state = h("p", { class: "state", role: "status" });
  private reply: LabelsReply | null = null;
  private object: number | null = null;
  private active = false;
  private draggedBox: LabelBox | null = null;
  private grab = { dx: 0, dy: 0 };

  constructor(
    private readonly ask: (request: Asked) => void,
    private readonly frameShown: () => number,
    private readonly settings: Settings,
    private readonly drawBoxes: (boxes: LabelBox[]) => void,
  ) {
    const act = (text: string, does: () => void, kind = "") =>
      h("button", { type: "button", class: kind, onclick: does }, text);
    this.element.append(
      h("p", { class: "hint" },
        "Select a track and accept it: over its whole life it becomes an object of the truth. " +
        "Then correct, name, merge and split."),
      h("div", { class: "line" },
        act("Accept track", () => this.accept(), "primary"),
        act("Accept in this frame", () => this.acceptFrame()),
        act("Undo", () => this.change("undo"))),
      h("div", { class: "line" }, act("Save truth CSV", () => this.change("save"), "primary")),
      this.state, this.editor, h("h3", {}, "Objects"), this.list);
  }

  setActive(active: boolean): void {
    this.active = active;
    if (active) this.refresh();
    else this.drawBoxes([]);
  }

  /** The frame changed: its boxes are asked for. */
  refresh(): void {
    if (this.active) this.change("list");
  }

  accept(): void {
    if (this.settings.selected === null) this.say("Select a track first.");
    else this.change("accept", { track: this.settings.selected });
  }

  show(reply: LabelsReply): void {
    this.reply = reply;
    if (reply.csv !== undefined && reply.file === "") download("truth.csv", reply.csv, "text/csv");
    const where = reply.file === "" ? "" : ` to ${reply.file}`;
    if (reply.csv !== undefined) this.say(`Saved ${reply.objects.length} objects${where}.`);
    else this.say(reply.saved ? "" : "Not saved yet.");
    if (!reply.objects.some((o) => o.id === this.object)) {
      this.object = reply.objects.find((o) => o.id === this.settings.selected)?.id ?? null;
    }
    if (this.active && reply.frame === this.frameShown()) this.drawBoxes(reply.boxes);
    this.drawList();
    this.drawEditor();
  }

  /** Whether a press there begins to drag the chosen object. */
  grabs(x: number, y: number): boolean {
    const box = this.chosenBox();
    if (!this.active || !box || !contains(box, x, y, 0.1)) return false;
    this.draggedBox = { ...box };
    this.grab = { dx: box.x - x, dy: box.y - y };
    return true;
  }

  dragTo(x: number, y: number, done: boolean): void {
    const box = this.draggedBox;
    if (!box || !this.reply) return;
    box.x = x + this.grab.dx;
    box.y = y + this.grab.dy;
    this.drawBoxes(this.reply.boxes.map((one) => (one.id === box.id ? box : one)));
    if (done) {
      this.correct(box);
      this.draggedBox = null;
    }
  }

  private say(text: string): void {
    this.state.textContent = text;
  }

  private change(action: string, more: Record<string, number | string> = {}): void {
    this.ask({ op: "label", action, frame: this.frameShown(), ...more });
  }

  private acceptFrame(): void {
    if (this.settings.selected === null) return this.say("Select a track first.");
    const into = this.object === null ? {} : { object: this.object };
    this.change("accept_frame", { track: this.settings.selected, ...into });
  }

  private correct(box: LabelBox): void {
    this.change("correct", {
      object: box.id, x_m: box.x, y_m: box.y, heading_rad: box.heading, length_m: box.length, width_m: box.width,
    });
  }

  private chosenBox(): LabelBox | undefined {
    return this.reply?.boxes.find((box) => box.id === this.object);
  }

  private drawList(): void {
    const objects = this.reply?.objects ?? [];
    fill(this.list, ...objects.map((object) => h("li", {}, h("button", {
      type: "button",
      class: object.id === this.object ? "row chosen" : "row",
      "aria-pressed": object.id === this.object ? "true" : "false",
      onclick: () => {
        this.object = object.id;
        this.drawList();
        this.drawEditor();
      },
    }, `${object.id} ${object.class}, frames ${object.first} to ${object.last}`))));
    if (objects.length === 0) fill(this.list, h("li", { class: "hint" }, "none yet"));
  }

  private drawEditor(): void {
    const object = this.reply?.objects.find((one) => one.id === this.object);
    if (!object) return fill(this.editor);
    const act = (text: string, does: () => void) => h("button", { type: "button", onclick: does }, text);
    const others = (this.reply?.objects ?? []).filter((one) => one.id !== object.id);
    fill(this.editor,
      h("h2", {}, `Object ${object.id}`),
      h("div", { class: "line" }, "is a ", choice(CLASSES, object.class, "Class", (name) =>
        this.change("class", { object: object.id, class: name }))),
      ...this.mergeLine(object, others),
      h("div", { class: "line" },
        act("Split here", () => this.change("split", { object: object.id })),
        act("Remove here", () => this.change("remove_frame", { object: object.id })),
        act("Remove object", () => this.change("remove", { object: object.id }))),
      ...this.boxFields());
  }

  private mergeLine(object: LabelObject, others: LabelObject[]): HTMLElement[] {
    if (others.length === 0) return [];
    const names = ["choose", ...others.map((one) => String(one.id))];
    return [h("div", { class: "line" }, "same as object ", choice(names, "choose", "Merge into", (name) => {
      if (name !== "choose") this.change("merge", { object: object.id, other: Number(name) });
    }))];
  }

  private boxFields(): HTMLElement[] {
    const box = this.chosenBox();
    if (!box) return [h("p", { class: "hint" }, "It has no box in this frame.")];
    const field = (name: string, value: number, set: (v: number) => void) => {
      const input = h("input", { type: "number", step: "0.05", value: value.toFixed(2), "aria-label": name });
      input.addEventListener("change", () => {
        const typed = Number(input.value);
        if (input.value === "" || !Number.isFinite(typed)) return;
        set(typed);
        this.correct(box);
      });
      return h("label", { class: "number" }, name, input);
    };
    return [
      h("p", { class: "hint" }, "Drag the box in the scene, or type:"),
      h("div", { class: "grid" },
        field("x / m", box.x, (v) => (box.x = v)),
        field("y / m", box.y, (v) => (box.y = v)),
        field("heading / deg", box.heading * DEGREES, (v) => (box.heading = v / DEGREES)),
        field("length / m", box.length, (v) => (box.length = v)),
        field("width / m", box.width, (v) => (box.width = v))),
    ];
  }
}
