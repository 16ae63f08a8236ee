import { clock, fill, h } from "../dom";
import type { Hello, Status } from "../messages";

/** What the recording is, and what was odd in it. */
export class InfoPanel {
  readonly element = h("section", { class: "panel", "aria-label": "Recording" });
  private readonly facts = h("dl", { class: "facts" });
  private readonly odd = h("div");
  private hello: Hello | null = null;

  constructor() {
    this.element.append(h("h2", {}, "Recording"), this.facts, this.odd);
  }

  greet(hello: Hello): void {
    this.hello = hello;
  }

  show(status: Status, duration: number, held: number, drawMs: number): void {
    const rows: [string, string][] = [
      ["name", this.hello?.title ?? ""],
      ["preset", this.hello?.preset ?? ""],
      ["frames", `${status.frames}${status.done ? "" : ", still reading"}`],
      ["duration", clock(duration)],
      ["sensors", status.sensors.join(", ") || "none yet"],
      ["confirmed tracks", String(status.confirmed)],
      ["truth", status.has_truth ? "yes" : "none given"],
      ["put aside on disk", megabytes(status.disk_bytes)],
      ["held in this page", megabytes(held)],
      ["drawing takes", `${drawMs.toFixed(1)} ms`],
    ];
    fill(this.facts, ...rows.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
    const lines = status.diagnostics.map((d) =>
      h("li", { class: d.damage ? "warning" : "" }, `${d.count} x ${d.what}${d.first ? `, first at ${d.first}` : ""}`));
    fill(this.odd, ...(lines.length > 0 ? [h("h3", {}, "Odd in the input"), h("ul", {}, ...lines)] : []));
  }
}

function megabytes(bytes: number): string {
  return `${(bytes / 1e6).toFixed(1)} MB`;
}
