import { describe, expect, it } from "vitest";

import { decode } from "../src/protocol";
import { frameBytes, sampleFrame } from "./sample";

describe("decode", () => {
  it("reads every section of a frame", () => {
    const frame = sampleFrame(0, 3, 5);
    expect(frame.time).toBe(12.5);
    expect(frame.number).toBe(77);
    expect([...frame.positions.slice(0, 3)]).toEqual([0, 1, 2]);
    expect([...frame.clusters]).toEqual([0, 1, 0, 1, 0]);
    expect([...frame.layers]).toEqual([0, 1, 2, 3, 0]);
    expect([...frame.detectionOfCluster]).toEqual([0]);
    expect(frame.lines[0]).toEqual({ x0: 0, y0: 0, x1: 1, y1: 1, cluster: 0 });
    expect(frame.detections[0]?.points).toBe(33);
    const track = frame.tracks[0];
    expect(track?.id).toBe(42);
    expect(track?.status).toBe(1);
    expect(track?.nis).toBeCloseTo(2.5);
    expect(track?.age).toBe(7);
    expect(frame.edges).toEqual([{ from: [0, 0, 0], to: [0, 0, 0.5], part: 1 }]);
    expect(frame.truth[0]?.id).toBe(9);
  });

  it("refuses a frame that is cut off anywhere", () => {
    const whole = frameBytes(0, 0, 9);
    for (let length = 0; length < whole.byteLength; ++length) {
      expect(() => decode(whole.slice(0, length))).toThrow();
    }
  });

  it("refuses a kind it does not know", () => {
    expect(() => decode(new Uint32Array([99]).buffer)).toThrow(/unknown message kind 99/);
  });

  it("reads stamps", () => {
    const bytes = new ArrayBuffer(32);
    new Uint32Array(bytes, 0, 4).set([2, 0, 5, 2]);
    new Float64Array(bytes, 16).set([0.5, 0.6]);
    const part = decode(bytes);
    expect(part.kind === "index" && [part.from, ...part.times]).toEqual([5, 0.5, 0.6]);
  });
});
