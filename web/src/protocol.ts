// What the server sends; docs/viewer-protocol.md describes it byte by byte.

import { type Binary, type Box, type Detection, MAIN, type Pose, type RunName, type Track, TRIAL } from "./model";

export * from "./model";

/** Reads numbers one after the other; past the end it throws a RangeError. */
class Reader {
  private offset = 0;
  private readonly view: DataView;

  constructor(private readonly bytes: ArrayBuffer) {
    this.view = new DataView(bytes);
  }

  u32(): number {
    this.offset += 4;
    return this.view.getUint32(this.offset - 4, true);
  }
  i32(): number {
    this.offset += 4;
    return this.view.getInt32(this.offset - 4, true);
  }
  f32(): number {
    this.offset += 4;
    return this.view.getFloat32(this.offset - 4, true);
  }
  f64(): number {
    this.offset += 8;
    return this.view.getFloat64(this.offset - 8, true);
  }
  /** `count` numbers as they stand, then up to a multiple of four. */
  array<T>(
    type: { new (b: ArrayBuffer, o: number, n: number): T; BYTES_PER_ELEMENT: number },
    count: number,
  ): T {
    const values = new type(this.bytes, this.offset, count);
    this.offset += count * type.BYTES_PER_ELEMENT;
    this.offset = (this.offset + 3) & ~3;
    return values;
  }
  run(): RunName {
    return this.u32() === 1 ? TRIAL : MAIN;
  }
}

function many<T>(count: number, read: () => T): T[] {
  const all: T[] = [];
  for (let i = 0; i < count; ++i) all.push(read());
  return all;
}

function readPose(r: Reader): Pose {
  return { x: r.f32(), y: r.f32(), z: r.f32(), heading: r.f32() };
}

function readBox(r: Reader): Box {
  return {
    x: r.f32(),
    y: r.f32(),
    z: r.f32(),
    heading: r.f32(),
    length: r.f32(),
    width: r.f32(),
    height: r.f32(),
  };
}

function readDetection(r: Reader): Detection {
  const box = readBox(r);
  const covariance: [number, number, number] = [r.f32(), r.f32(), r.f32()];
  const score = r.f32();
  const packed = r.u32();
  return { ...box, covariance, score, class: packed & 0xff, points: packed >>> 8 };
}

function readTrack(r: Reader): Track {
  const id = r.f64();
  const box = readBox(r);
  const rest = {
    vx: r.f32(),
    vy: r.f32(),
    covariance: [r.f32(), r.f32(), r.f32()] as [number, number, number],
    speed: r.f32(),
    accel: r.f32(),
    yawRate: r.f32(),
    classProbability: r.f32(),
    movingProbability: r.f32(),
    nis: r.f32(),
    detection: r.i32(),
    age: r.u32(),
    missed: r.u32(),
  };
  const packed = r.u32();
  return { id, ...box, ...rest, class: packed & 0xff, status: (packed >>> 8) & 0xff };
}

function readFrame(r: Reader, bytes: ArrayBuffer): Binary {
  const run = r.run();
  const frame = r.u32();
  const [points, clusters, lines, detections, tracks, truth, rays] = many(7, () => r.u32()) as [
    number, number, number, number, number, number, number,
  ];
  if (points * 16 > bytes.byteLength) throw new RangeError("a frame that is cut off");
  const head = {
    time: r.f64(),
    number: r.f64(),
    sensorPose: readPose(r),
    egoPose: readPose(r),
    intensityLow: r.f32(),
    intensityHigh: r.f32(),
    sensor: r.u32(),
  };
  const edges = r.u32();
  return {
    kind: "frame",
    run,
    frame,
    ...head,
    positions: r.array(Float32Array, 3 * points),
    clusters: r.array(Uint16Array, points),
    layers: r.array(Uint8Array, points),
    intensities: r.array(Uint8Array, points),
    detectionOfCluster: r.array(Int32Array, clusters),
    lines: many(lines, () => ({
      x0: r.f32(), y0: r.f32(), x1: r.f32(), y1: r.f32(), cluster: r.u32(),
    })),
    detections: many(detections, () => readDetection(r)),
    tracks: many(tracks, () => readTrack(r)),
    rays: many(rays, () => ({
      from: [r.f32(), r.f32(), r.f32()],
      to: [r.f32(), r.f32(), r.f32()],
      sensor: r.u32(),
      target: r.i32(),
    })),
    edges: many(edges, () => ({
      from: [r.f32(), r.f32(), r.f32()],
      to: [r.f32(), r.f32(), r.f32()],
      part: r.u32(),
    })),
    truth: many(truth, () => {
      const id = r.f64();
      return { id, ...readBox(r), class: r.u32() };
    }),
  };
}

function readHistory(r: Reader): Binary {
  const run = r.run();
  const count = r.u32();
  r.u32();
  const track = r.f64();
  const samples = many(count, () => {
    const time = r.f64();
    const frame = r.u32();
    r.u32();
    return { time, frame, ...readTrack(r) };
  });
  return { kind: "history", run, track, samples };
}

/** Throws on what is no message of this protocol. */
export function decode(bytes: ArrayBuffer): Binary {
  const r = new Reader(bytes);
  const kind = r.u32();
  switch (kind) {
    case 1:
      return readFrame(r, bytes);
    case 2: {
      const run = r.run();
      const from = r.u32();
      return { kind: "index", run, from, times: r.array(Float64Array, r.u32()) };
    }
    case 3: {
      const run = r.run();
      const from = r.u32();
      const events = many(r.u32(), () => ({ track: r.f64(), frame: r.u32(), kind: r.u32() }));
      return { kind: "events", run, from, events };
    }
    case 4:
      return readHistory(r);
    case 5: {
      const run = r.run();
      const points = many(r.u32(), () => ({
        frame: r.u32(), id: r.f64(), x: r.f32(), y: r.f32(),
      }));
      return { kind: "trails", run, points };
    }
    default:
      throw new Error(`unknown message kind ${kind}`);
  }
}
