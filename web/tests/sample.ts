import { decode, type Frame } from "../src/protocol";

/** Bytes of a frame message with `points` returns, one cluster, one detection and one track. */
export function frameBytes(run: number, frame: number, points: number): ArrayBuffer {
  const bytes: number[] = [];
  const put = (size: number, set: (view: DataView) => void) => {
    const view = new DataView(new ArrayBuffer(size));
    set(view);
    for (let i = 0; i < size; ++i) bytes.push(view.getUint8(i));
  };
  const u32 = (v: number) => put(4, (d) => d.setUint32(0, v, true));
  const i32 = (v: number) => put(4, (d) => d.setInt32(0, v, true));
  const f32 = (v: number) => put(4, (d) => d.setFloat32(0, v, true));
  const f64 = (v: number) => put(8, (d) => d.setFloat64(0, v, true));
  const align = () => {
    while (bytes.length % 4 !== 0) bytes.push(0);
  };
  for (const v of [1, run, frame, points, 1, 1, 1, 1, 1, 0]) u32(v);
  f64(12.5);
  f64(77);
  for (const v of [1, 2, 3, 0.5, 4, 5, 6, 0.25]) f32(v);
  f32(0);
  f32(255);
  u32(0);
  u32(1);
  for (let i = 0; i < 3 * points; ++i) f32(i);
  for (let i = 0; i < points; ++i) bytes.push(i % 2, 0);
  align();
  for (let i = 0; i < points; ++i) bytes.push(i % 4);
  align();
  for (let i = 0; i < points; ++i) bytes.push(i % 256);
  align();
  i32(0);
  for (const v of [0, 0, 1, 1]) f32(v);
  u32(0);
  for (const v of [10, 20, 0, 0.1, 4, 2, 1.5, 0.1, 0.02, 0.2, 0.9]) f32(v);
  u32(1 | (33 << 8));
  f64(42);
  for (const v of [10, 20, 0, 0.1, 4, 2, 1.5, 3, 4, 0.1, 0.02, 0.2, 5, 0, 0, 0.75, 0.5, 2.5]) f32(v);
  i32(0);
  for (const v of [7, 0, 1 | (1 << 8)]) u32(v);
  for (const v of [0, 0, 0, 0, 0, 0.5]) f32(v);
  u32(1);
  f64(9);
  for (const v of [10, 20, 0, 0.1, 4, 2, 1.5]) f32(v);
  u32(1);
  return new Uint8Array(bytes).buffer;
}

export function sampleFrame(run: number, frame: number, points = 5): Frame {
  const decoded = decode(frameBytes(run, frame, points));
  if (decoded.kind !== "frame") throw new Error("not a frame");
  return decoded;
}
