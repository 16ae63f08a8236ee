import { Connection } from "./connection";
import { TopBar, Transport } from "./controls";
import { h } from "./dom";
import { FrameStore } from "./frame_store";
import { helpSheet } from "./help";
import { listenForKeys } from "./keys";
import { Legend } from "./legend";
import type { Hello, Status, Told } from "./messages";
import { InfoPanel } from "./panels/info_panel";
import { LabelPanel } from "./panels/label_panel";
import { Tabs } from "./panels/tabs";
import { TrackPanel } from "./panels/track_panel";
import { TunePanel } from "./panels/tune_panel";
import { Player } from "./player";
import { type Binary, type Frame, MAIN, type RunName, TRIAL } from "./protocol";
import { Settings } from "./settings";
import { applyTheme } from "./theme";
import { Timeline } from "./timeline";
import { commandsOf } from "./commands";
import { Stage } from "./view/stage";

const TRAIL_FRAMES = 60;
const AHEAD = 3;

/** Everything together: what comes in goes to those who show it, what the user does goes out. */
export class App {
  readonly settings = new Settings(safeStorage());
  readonly player = new Player();
  readonly connection = new Connection();
  readonly store = new FrameStore((request) => this.connection.ask(request));
  readonly stage = new Stage(this.settings);
  readonly timeline = new Timeline(this.player, this.settings);
  readonly label: LabelPanel;
  readonly tabs: Tabs;
  readonly help: HTMLDialogElement;
  private readonly bar: TopBar;
  private readonly legend: Legend;
  private readonly track: TrackPanel;
  private readonly tune: TunePanel;
  private readonly info = new InfoPanel();
  private readonly names = { classes: [] as string[], statuses: [] as string[] };
  private status: Status | null = null;
  private last = 0;
  private indexAsked = -1;
  private eventsAsked = -1;
  private trialShown = 0;

  constructor(root: HTMLElement) {
    this.track = new TrackPanel(this.settings, this.names,
      (time) => this.player.seek(this.player.frameAt(time)), (id) => this.select(id));
    this.tune = new TunePanel((request) => this.connection.ask(request), () => this.player.frame,
      (on) => this.settings.change((s) => (s.compare = on)));
    this.label = new LabelPanel((request) => this.connection.ask(request), () => this.player.frame,
      this.settings, (boxes) => this.drawLabels(boxes));
    this.tabs = new Tabs([
      ["Track", this.track.element], ["Tune", this.tune.element],
      ["Label", this.label.element], ["Info", this.info.element],
    ], (name) => this.label.setActive(name === "Label"));
    this.legend = new Legend(this.settings, () => this.names.classes);
    const commands = commandsOf(this);
    this.help = helpSheet(commands);
    listenForKeys(commands);
    this.bar = new TopBar(this.settings, () => this.help.showModal(), () => this.stage.fit());
    const transport = new Transport(this.player, (direction) => this.jump(direction));
    root.append(this.bar.element,
      h("main", {}, h("div", { class: "scene" }, this.stage.element, this.legend.element, this.heads()), this.tabs.element),
      h("footer", {}, transport.element, this.timeline.element), this.help);
    this.connect();
  }

  start(): void {
    applyTheme(this.settings.theme);
    this.stage.restyle();
    this.connection.connect();
    const tick = (now: number) => {
      this.player.advance((now - this.last) / 1000, (frame) => this.ready(frame));
      this.last = now;
      this.prefetch();
      this.stage.draw();
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  select(id: number | null): void {
    this.settings.change((s) => (s.selected = id));
    this.track.clear();
    this.timeline.life = null;
    if (id !== null) {
      this.tabs.open("Track");
      this.connection.ask({ op: "history", run: MAIN, track: id });
    }
    this.refresh();
  }

  jump(direction: 1 | -1): void {
    const event = this.timeline.nextEvent(direction);
    if (!event) return;
    this.player.pause();
    this.player.seek(event.frame);
    if (event.track !== this.settings.selected) this.select(event.track);
  }

  /** Selects the next or the one before among the tracks of this frame. */
  cycle(direction: 1 | -1): void {
    const ids = this.stage.panes[0].visibleTracks().map((track) => track.id).sort((a, b) => a - b);
    if (ids.length === 0) return;
    const at = ids.indexOf(this.settings.selected ?? NaN);
    const next = at < 0 ? (direction > 0 ? 0 : ids.length - 1) : (at + direction + ids.length) % ids.length;
    this.select(ids[next] ?? null);
  }

  private heads(): HTMLElement {
    const heads = h("div", { class: "heads" }, h("span", {}, "left: as configured"), h("span", {}, "right: trial"));
    this.settings.changed.on(() => (heads.hidden = !this.settings.compare));
    heads.hidden = true;
    return heads;
  }

  private connect(): void {
    this.connection.told.on((message) => this.hear(message));
    this.connection.binary.on((message) => this.take(message));
    this.connection.link.on((link) => {
      if (link === "lost") this.bar.setNote("connection lost, trying again", true);
      if (link === "open") this.indexAsked = this.eventsAsked = -1;
    });
    this.settings.changed.on(() => {
      applyTheme(this.settings.theme);
      this.stage.restyle();
      this.track.restyle();
      this.timeline.draw();
      this.refresh();
    });
    this.player.moved.on(() => this.showCurrent());
    this.stage.picked.on((track) => this.select(track?.id ?? null));
    this.stage.grabs = (x, y) => this.label.grabs(x, y);
    this.stage.dragged.on(({ x, y, done }) => this.label.dragTo(x, y, done));
  }

  private hear(message: Told): void {
    switch (message.op) {
      case "hello": return this.greet(message);
      case "status": return this.update(message);
      case "options": return this.tune.showOptions(message);
      case "metrics": return this.tune.showMetrics(message);
      case "export": return this.tune.saveExport(message.toml);
      case "labels": return this.label.show(message);
      case "missing": return this.store.missing(message.run, message.frame);
      case "problem": return this.bar.setNote(`${message.of}: ${message.what}`, true);
    }
  }

  private greet(hello: Hello): void {
    this.bar.setTitle(hello.title);
    this.names.classes = hello.classes;
    this.names.statuses = hello.statuses;
    this.store.forget();
    this.player.live = hello.live;
    if (hello.live) this.player.play();
    this.tune.greet(hello);
    this.info.greet(hello);
  }

  private update(status: Status): void {
    this.status = status;
    if (status.frames > this.player.count && this.indexAsked < status.frames) {
      this.indexAsked = status.frames;
      this.connection.ask({ op: "index", run: MAIN, from: this.player.count });
    }
    if (status.events > this.timeline.events.length && this.eventsAsked < status.events) {
      this.eventsAsked = status.events;
      this.connection.ask({ op: "events", run: MAIN, from: this.timeline.events.length });
    }
    if (status.trial !== this.trialShown) {
      this.trialShown = status.trial;
      this.store.forget(TRIAL);
      this.stage.panes[1].trails.forget();
    }
    this.timeline.trial = status.trial_from !== undefined && status.trial_end !== undefined
      ? [status.trial_from, status.trial_end - 1] : null;
    this.timeline.draw();
    this.tune.showStatus(status);
    const reading = this.player.live ? `live: ${status.frames} frames so far` : `reading and tracking: ${status.frames} frames so far`;
    if (status.problem !== "") this.bar.setNote(status.problem, true);
    else this.bar.setNote(status.done ? "" : reading);
    this.showInfo();
  }

  private take(message: Binary): void {
    switch (message.kind) {
      case "frame": return this.takeFrame(message);
      case "index": {
        this.player.setTimes(message.from, message.times);
        return this.showCurrent();
      }
      case "events":
        this.timeline.events.length = Math.min(this.timeline.events.length, message.from);
        this.timeline.events.push(...message.events);
        return this.timeline.draw();
      case "history":
        this.track.showHistory(message);
        this.timeline.life = this.track.life;
        return this.timeline.draw();
      case "trails":
        this.stage.panes[message.run].trails.addMany(message.points);
        return this.refresh();
    }
  }

  private takeFrame(frame: Frame): void {
    this.store.add(frame);
    this.stage.panes[frame.run].trails.add(frame);
    if (frame.frame === this.player.frame) this.refresh();
  }

  private ready(frame: number): boolean {
    const main = this.store.want(MAIN, frame);
    return this.settings.compare ? this.store.want(TRIAL, frame) && main : main;
  }

  /** The frames that come next, while nothing more urgent is waited for. */
  private prefetch(): void {
    const { frame, count, playing } = this.player;
    if (count === 0) return;
    for (const run of this.runs()) {
      if (!this.store.want(run, frame, true)) continue;
      for (let i = 1; playing && i <= AHEAD && frame + i < count; ++i) this.store.want(run, frame + i);
      for (let i = 1; i < this.settings.scansKept && frame - i >= 0; ++i) this.store.want(run, frame - i);
    }
  }

  private runs(): RunName[] {
    return this.settings.compare ? [MAIN, TRIAL] : [MAIN];
  }

  private showCurrent(): void {
    this.label.refresh();
    const { frame } = this.player;
    for (const run of this.runs()) {
      const trails = this.stage.panes[run].trails;
      if (this.player.playing || trails.knows(frame - TRAIL_FRAMES, frame)) continue;
      trails.mark(frame - TRAIL_FRAMES, frame - 1);
      this.connection.ask({ op: "trails", run, frame, length: TRAIL_FRAMES });
    }
    this.refresh();
  }

  /** Draws the frame of the clock, if it is here. */
  refresh(): void {
    for (const run of this.runs()) {
      const frames = this.kept(run);
      if (frames.length > 0) this.stage.show(run, frames);
      if (run === MAIN && frames[0]) {
        this.track.showFrame(frames[0]);
        this.legend.draw(frames[0]);
      }
    }
    this.stage.redraw();
  }

  private kept(run: RunName): Frame[] {
    const frames: Frame[] = [];
    for (let i = 0; i < this.settings.scansKept; ++i) {
      const found = this.store.get(run, this.player.frame - i);
      if (found) frames.push(found);
      else if (i === 0) return [];
    }
    return frames;
  }

  private drawLabels(boxes: Parameters<LabelPanel["show"]>[0]["boxes"]): void {
    this.stage.panes[0].labels = boxes;
    this.refresh();
  }

  private showInfo(): void {
    const times = [...this.stage.frameTimes].sort((a, b) => a - b);
    const median = times[Math.floor(times.length / 2)] ?? 0;
    if (this.status) this.info.show(this.status, this.player.duration, this.store.bytesHeld, median);
  }
}

function safeStorage(): Storage | null {
  try {
    return window.localStorage;
  } catch {
    return null;
  }
}
