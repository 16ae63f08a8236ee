import { clock, fill, h } from "../dom";
import type { Frame, History, HistorySample, Track } from "../protocol";
import type { Settings } from "../settings";
import { clusterOfTrack } from "../view/colours";
import { Charts, NIS_BAND } from "./charts";

const DEGREES = 180 / Math.PI;

/** What is known of the selected track: numbers of this frame, and its curves. */
export class TrackPanel {
  readonly element = h("section", { class: "panel", "aria-label": "Track" });
  private readonly numbers = h("div");
  private readonly hint = h("p", { class: "hint" },
    "Click a track in the scene, or a name in the list, to see its history.");
  private readonly list = h("ul", { class: "tracks" });
  private readonly charts: Charts;
  private samples: HistorySample[] = [];

  constructor(
    private readonly settings: Settings,
    private readonly names: { classes: string[]; statuses: string[] },
    goTo: (time: number) => void,
    private readonly select: (id: number | null) => void,
  ) {
    this.charts = new Charts(goTo);
    this.element.append(this.hint, this.numbers, this.charts.element, h("h3", {}, "In this frame"), this.list);
  }

  showFrame(frame: Frame): void {
    const track = frame.tracks.find((one) => one.id === this.settings.selected);
    this.hint.hidden = this.settings.selected !== null;
    if (this.settings.selected === null) fill(this.numbers);
    else fill(this.numbers, ...this.describe(track, frame));
    this.charts.setTime(frame.time);
    this.showList(frame);
  }

  showHistory(history: History): void {
    if (history.track !== this.settings.selected) return;
    this.samples = history.samples;
    this.charts.show(history.samples, this.settings.theme);
  }

  restyle(): void {
    if (this.settings.selected === null) this.charts.clear();
    else if (this.samples.length > 0) this.charts.show(this.samples, this.settings.theme);
  }

  clear(): void {
    this.samples = [];
    this.charts.clear();
  }

  /** First and last frame in which the track shown lived. */
  get life(): [number, number] | null {
    const first = this.samples[0];
    const last = this.samples[this.samples.length - 1];
    return first && last && this.settings.selected !== null ? [first.frame, last.frame] : null;
  }

  private describe(track: Track | undefined, frame: Frame): (HTMLElement | string)[] {
    const title = h("h2", {}, `Track ${this.settings.selected}`,
      h("button", { type: "button", class: "small", onclick: () => this.select(null) }, "Deselect"));
    if (!track) return [title, h("p", { class: "hint" }, "Not in this frame.")];
    const inBand = track.nis >= NIS_BAND[0] && track.nis <= NIS_BAND[1];
    const cluster = clusterOfTrack(frame, track.id);
    const support = cluster === 0 ? 0 : frame.clusters.reduce((n, c) => n + (c === cluster ? 1 : 0), 0);
    const rows: [string, string][] = [
      ["class", `${this.names.classes[track.class] ?? "?"}, ${(100 * track.classProbability).toFixed(0)} %`],
      ["status", `${this.names.statuses[track.status] ?? "?"}, ${track.age} frames old`],
      ["speed", `${track.speed.toFixed(2)} m/s, moves: ${(100 * track.movingProbability).toFixed(0)} %`],
      ["heading", `${(track.heading * DEGREES).toFixed(1)} deg, turns ${(track.yawRate * DEGREES).toFixed(1)} deg/s`],
      ["size", `${track.length.toFixed(2)} x ${track.width.toFixed(2)} m`],
      ["position", `${track.x.toFixed(2)}, ${track.y.toFixed(2)} m`],
      ["1 sigma", `${Math.sqrt(track.covariance[0]).toFixed(2)}, ${Math.sqrt(track.covariance[2]).toFixed(2)} m`],
      ["seen by", track.detection < 0 ? "nothing in this scan" : `${support} returns (marked)`],
      ["innovation", track.detection < 0 ? "-" : `NIS ${track.nis.toFixed(2)}, ${inBand ? "inside" : "outside"} its 95 % band`],
    ];
    const table = h("dl", { class: "facts" });
    for (const [name, value] of rows) table.append(h("dt", {}, name), h("dd", {}, value));
    return [title, table];
  }

  private showList(frame: Frame): void {
    const tracks = frame.tracks.filter((t) => this.settings.shown.tentative || t.status !== 0);
    fill(this.list, ...tracks.slice(0, 60).map((track) => {
      const text = `${track.id} ${this.names.classes[track.class] ?? "?"}, ${track.speed.toFixed(1)} m/s`;
      const chosen = track.id === this.settings.selected;
      return h("li", {}, h("button", {
        type: "button", class: chosen ? "row chosen" : "row", "aria-pressed": chosen ? "true" : "false",
        onclick: () => this.select(track.id),
      }, text));
    }));
    if (tracks.length === 0) fill(this.list, h("li", { class: "hint" }, `no confirmed tracks at ${clock(frame.time)}`));
  }
}
