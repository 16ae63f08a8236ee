import { describe, expect, it } from "vitest";

import { FrameStore } from "../src/frame_store";
import type { Asked } from "../src/messages";
import { MAIN, TRIAL } from "../src/protocol";
import { sampleFrame } from "./sample";

describe("FrameStore", () => {
  it("asks once for a frame, and for a few at a time only", () => {
    const asked: Asked[] = [];
    const store = new FrameStore((request) => asked.push(request), 1e9, 3);
    for (let i = 0; i < 10; ++i) store.want(MAIN, i);
    store.want(MAIN, 0);
    expect(asked).toHaveLength(3);
    store.add(sampleFrame(0, 0));
    expect(store.want(MAIN, 0)).toBe(true);
    store.want(MAIN, 5);
    expect(asked).toHaveLength(4);
  });

  it("asks again when an answer does not come", () => {
    const asked: Asked[] = [];
    const store = new FrameStore((request) => asked.push(request));
    store.want(MAIN, 1, false, 0);
    store.want(MAIN, 1, false, 1000);
    expect(asked).toHaveLength(1);
    store.want(MAIN, 1, false, 6001);
    expect(asked).toHaveLength(2);
  });

  it("holds no more than its share of memory and drops what was used longest ago", () => {
    const one = sampleFrame(0, 0, 1000).positions.buffer.byteLength;
    const store = new FrameStore(() => {}, 3.5 * (one + 400));
    for (let i = 0; i < 3; ++i) store.add(sampleFrame(0, i, 1000));
    store.get(MAIN, 0);
    store.add(sampleFrame(0, 3, 1000));
    expect(store.get(MAIN, 1)).toBeUndefined();
    expect(store.get(MAIN, 0)).toBeDefined();
    expect(store.bytesHeld).toBeLessThanOrEqual(3.5 * (one + 400));
  });

  it("forgets one run and keeps the other", () => {
    const store = new FrameStore(() => {});
    store.add(sampleFrame(0, 0));
    store.add(sampleFrame(1, 0));
    store.forget(TRIAL);
    expect(store.get(MAIN, 0)).toBeDefined();
    expect(store.get(TRIAL, 0)).toBeUndefined();
  });
});
