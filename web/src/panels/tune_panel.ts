import { choice, download, fill, h } from "../dom";
import type { Asked, Hello, Metrics, MetricsReply, OptionsReply, Status } from "../messages";
import { MAIN, TRIAL } from "../protocol";
import { OptionsForm } from "./options_form";

/** The metrics shown: name, where they stand, digits, whether more is better. */
const ROWS: [string, (m: Metrics) => number | null | undefined, number, boolean][] = [
  ["MOTA", (m) => m.clear["MOTA"], 3, true],
  ["HOTA", (m) => m.hota["HOTA"], 3, true],
  ["IDF1", (m) => m.identity["IDF1"], 3, true],
  ["identity switches", (m) => m.clear["IDSW"], 0, false],
  ["position RMSE / m", (m) => m.rmse["position_m"], 3, false],
  ["velocity RMSE / (m/s)", (m) => m.rmse["velocity_m_per_s"], 3, false],
  ["GOSPA / m", (m) => m.gospa["gospa_m"], 3, false],
  ["false tracks a frame", (m) => m.ghosts_per_frame, 3, false],
];

/** Tries options from the frame shown on, beside the results there are. */
export class TunePanel {
  readonly element = h("section", { class: "panel", "aria-label": "Tune" });
  private readonly form: OptionsForm;
  private readonly state = h("p", { class: "state", role: "status" });
  private readonly table = h("div", { class: "metrics" });
  private readonly preset = h("div", { class: "line" });
  private chosen = "";
  private timer = 0;
  private scored = -1;
  private hasTruth = false;
  private trialExists = false;

  constructor(
    private readonly ask: (request: Asked) => void,
    private readonly frameShown: () => number,
    private readonly compare: (on: boolean) => void,
  ) {
    this.form = new OptionsForm(() => this.schedule());
    const act = (text: string, does: () => void, kind = "") =>
      h("button", { type: "button", class: kind, onclick: does }, text);
    this.element.append(
      h("p", { class: "hint" },
        "Change a value: the recording is run again from this frame, and shown at the right."),
      this.preset,
      h("div", { class: "line" },
        act("Try from here", () => this.start(), "primary"),
        act("End trial", () => this.end()),
        act("Undo changes", () => this.form.reset()),
        act("Export configuration", () => ask({ op: "export", run: this.trialExists ? TRIAL : MAIN }))),
      this.state, this.table, this.form.element);
  }

  greet(hello: Hello): void {
    fill(this.preset, "Start from ", choice(hello.presets, hello.preset, "Preset", (name) => {
      this.chosen = name;
      this.ask({ op: "options", preset: name });
      this.schedule();
    }));
    this.ask({ op: "options" });
  }

  showOptions(reply: OptionsReply): void {
    this.form.show(reply.options);
  }

  showStatus(status: Status): void {
    this.hasTruth = status.has_truth;
    this.trialExists = status.trial_end !== undefined;
    if (status.trial_end === undefined || status.trial_from === undefined) {
      this.state.textContent = "";
      fill(this.table);
      this.scored = -1;
      return;
    }
    const frames = Math.max(0, status.trial_end - status.trial_from);
    this.state.textContent =
      `${status.trial_runs ? "Running" : "Done"}: ${frames} frames from ${status.trial_from} on, ` +
      `${status.trial_confirmed ?? 0} tracks (all of the main run: ${status.confirmed}).`;
    const due = !status.trial_runs || status.trial_end > this.scored + 200;
    if (due && status.trial_end !== this.scored) {
      this.scored = status.trial_end;
      this.ask({ op: "metrics" });
    }
  }

  showMetrics(reply: MetricsReply): void {
    if (!this.hasTruth || !reply.main) {
      fill(this.table, h("p", { class: "hint" }, "Without truth there are no metrics: compare by eye, or give --truth."));
      return;
    }
    const main = reply.main;
    const rows = ROWS.map(([name, of, digits, more]) => {
      const a = of(main) ?? null;
      const b = reply.trial ? (of(reply.trial) ?? null) : null;
      const better = a === null || b === null || a === b ? "" : (b > a) === more ? " better" : " worse";
      const show = (v: number | null) => (v === null ? "-" : v.toFixed(digits));
      return h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, show(a)),
        h("td", { class: better.trim() }, show(b), better === "" ? "" : h("small", {}, better)));
    });
    fill(this.table, h("table", {},
      h("caption", {}, `Against truth, frames ${reply.from} to ${reply.end - 1}`),
      h("thead", {}, h("tr", {}, h("th", {}), h("th", { scope: "col" }, "left"), h("th", { scope: "col" }, "right (trial)"))),
      h("tbody", {}, ...rows)));
  }

  saveExport(toml: string): void {
    download("scanfuse.toml", toml, "application/toml");
  }

  /** A moment after the last change. */
  private schedule(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.start(), 400);
  }

  private start(): void {
    this.scored = -1;
    this.compare(true);
    const preset = this.chosen === "" ? {} : { preset: this.chosen };
    this.ask({ op: "tune", from: this.frameShown(), changes: this.form.changes, ...preset });
  }

  private end(): void {
    clearTimeout(this.timer);
    this.compare(false);
    this.ask({ op: "stop_tune" });
  }
}
