import type { Asked } from "./messages";
import type { Frame, RunName } from "./protocol";
import { Signal } from "./signal";

/** Frames in memory: those around the one shown. Asks for what is missing, a few at a time. */
export class FrameStore {
  readonly arrived = new Signal<Frame>();
  private readonly frames = new Map<string, Frame>();
  private readonly asked = new Map<string, number>();
  private bytes = 0;

  constructor(
    private readonly ask: (request: Asked) => void,
    private readonly mostBytes = 200e6,
    private readonly mostAsked = 4,
  ) {}

  get(run: RunName, frame: number): Frame | undefined {
    const key = `${run}:${frame}`;
    const found = this.frames.get(key);
    if (found) {
      // Used last: stays longest.
      this.frames.delete(key);
      this.frames.set(key, found);
    }
    return found;
  }

  /** Whether the frame is here; it is asked for when it is not and not too many are. */
  want(run: RunName, frame: number, urgent = false, now = Date.now()): boolean {
    const key = `${run}:${frame}`;
    if (this.frames.has(key)) return true;
    for (const [other, since] of this.asked) if (now - since > 5000) this.asked.delete(other);
    if (this.asked.has(key) || this.asked.size >= this.mostAsked + (urgent ? 2 : 0)) return false;
    this.asked.set(key, now);
    this.ask({ op: "frame", run, frame });
    return false;
  }

  add(frame: Frame): void {
    const key = `${frame.run}:${frame.frame}`;
    this.asked.delete(key);
    const old = this.frames.get(key);
    if (old) this.bytes -= size(old);
    this.frames.delete(key);
    this.frames.set(key, frame);
    this.bytes += size(frame);
    for (const [oldest, held] of this.frames) {
      if (this.bytes <= this.mostBytes || oldest === key) break;
      this.frames.delete(oldest);
      this.bytes -= size(held);
    }
    this.arrived.emit(frame);
  }

  missing(run: RunName, frame: number): void {
    this.asked.delete(`${run}:${frame}`);
  }

  /** Forgets a run, whose results are about to change, or all of them. */
  forget(run?: RunName): void {
    for (const [key, held] of this.frames) {
      if (run !== undefined && held.run !== run) continue;
      this.frames.delete(key);
      this.bytes -= size(held);
    }
    for (const key of this.asked.keys()) {
      if (run === undefined || key.startsWith(`${run}:`)) this.asked.delete(key);
    }
  }

  get bytesHeld(): number {
    return this.bytes;
  }
}

function size(frame: Frame): number {
  return frame.positions.buffer.byteLength + 200 * (frame.tracks.length + frame.lines.length);
}
