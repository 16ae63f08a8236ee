import type { Frame, TrailPoint } from "../protocol";

/** Where tracks have been, of all frames seen so far: a few numbers each. */
export class TrailMemory {
  private readonly byTrack = new Map<number, TrailPoint[]>();
  private readonly known = new Set<number>();

  add(frame: Frame): void {
    if (this.known.has(frame.frame)) return;
    this.known.add(frame.frame);
    for (const track of frame.tracks) {
      this.insert({ id: track.id, frame: frame.frame, x: track.x, y: track.y });
    }
  }

  /** What the server told of frames [from, to]. */
  addMany(points: TrailPoint[]): void {
    for (const point of points) if (!this.known.has(point.frame)) this.insert(point);
    for (const point of points) this.known.add(point.frame);
  }

  /** Whether all frames of [from, to] are known. */
  knows(from: number, to: number): boolean {
    for (let frame = Math.max(0, from); frame <= to; ++frame) {
      if (!this.known.has(frame)) return false;
    }
    return true;
  }

  /** Marks frames in which nothing moved as known. */
  mark(from: number, to: number): void {
    for (let frame = Math.max(0, from); frame <= to; ++frame) this.known.add(frame);
  }

  /** The trail of a track over frames [from, to], in order. */
  of(track: number, from: number, to: number): TrailPoint[] {
    const all = this.byTrack.get(track) ?? [];
    return all.slice(place(all, from), place(all, to + 1));
  }

  forget(): void {
    this.byTrack.clear();
    this.known.clear();
  }

  private insert(point: TrailPoint): void {
    const all = this.byTrack.get(point.id);
    if (!all) this.byTrack.set(point.id, [point]);
    else all.splice(place(all, point.frame), 0, point);
  }
}

/** The first place whose frame is not before `frame`. */
function place(points: TrailPoint[], frame: number): number {
  let low = 0;
  let high = points.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((points[middle]?.frame ?? 0) < frame) low = middle + 1;
    else high = middle;
  }
  return low;
}
