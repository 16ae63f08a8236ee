import { Signal } from "./signal";

/** The clock: which frame is shown, and which is next. Times are seconds since the start. */
export class Player {
  readonly moved = new Signal<number>();
  readonly changed = new Signal<void>();
  frame = 0;
  playing = false;
  speed = 1;
  /** Of sensors that are running: playing means to stay with the newest frame. */
  live = false;
  private due = 0;
  private times: number[] = [];
  private clock = 0;

  /** Stamps from frame `from` on. */
  setTimes(from: number, times: Float64Array): void {
    this.times.length = Math.min(this.times.length, from);
    for (const time of times) this.times.push(time);
    this.changed.emit();
  }

  get count(): number {
    return this.times.length;
  }
  get time(): number {
    return this.times[this.frame] ?? 0;
  }
  get duration(): number {
    return this.times[this.times.length - 1] ?? 0;
  }
  timeOf(frame: number): number {
    return this.times[frame] ?? 0;
  }

  /** The frame shown at a time: the last that is not later. */
  frameAt(time: number): number {
    let low = 0;
    let high = this.times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((this.times[middle] ?? 0) <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  seek(frame: number): void {
    const bounded = Math.max(0, Math.min(frame, this.count - 1));
    this.clock = this.timeOf(bounded);
    if (bounded === this.frame) return;
    this.frame = bounded;
    this.moved.emit(bounded);
  }

  step(by: number): void {
    this.pause();
    this.seek(this.frame + by);
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  play(): void {
    if (!this.live && this.frame >= this.count - 1) this.seek(0);
    this.clock = this.time;
    this.playing = true;
    this.changed.emit();
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    this.changed.emit();
  }

  setSpeed(speed: number): void {
    this.speed = speed;
    this.changed.emit();
  }

  /**
   * Goes on by `seconds` of the wall clock. Where the frame that is due is not here yet (`ready`
   * says so) the clock waits: a slow link plays slowly and skips nothing.
   */
  advance(seconds: number, ready: (frame: number) => boolean): void {
    if (!this.playing) return;
    if (this.live) return this.catchUp(ready);
    const due = this.clock + Math.min(seconds, 0.25) * this.speed;
    const next = this.frameAt(due);
    if (next !== this.frame && !ready(next)) return;
    this.clock = due;
    if (next !== this.frame) {
      this.frame = next;
      this.moved.emit(next);
    }
    if (next >= this.count - 1) this.pause();
  }
  /** Shows what was newest when it was asked for, then asks for what is newest by now. */
  private catchUp(ready: (frame: number) => boolean): void {
    if (this.due <= this.frame) this.due = this.count - 1;
    if (this.due > this.frame && ready(this.due)) this.seek(this.due);
  }
}
