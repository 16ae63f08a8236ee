import { describe, expect, it } from "vitest";

import { Player } from "../src/player";

function playerWith(times: number[]): Player {
  const player = new Player();
  player.setTimes(0, new Float64Array(times));
  return player;
}

describe("Player", () => {
  it("shows the last frame that is not later than the time", () => {
    const player = playerWith([0, 0.1, 0.2, 0.5]);
    expect([-1, 0, 0.05, 0.1, 0.49, 0.5, 9].map((t) => player.frameAt(t))).toEqual([0, 0, 0, 1, 2, 3, 3]);
  });

  it("plays at the recording's own pace and stops at its end", () => {
    const player = playerWith([0, 0.1, 0.2, 0.3]);
    player.play();
    player.advance(0.11, () => true);
    expect(player.frame).toBe(1);
    player.advance(0.2, () => true);
    expect(player.frame).toBe(3);
    expect(player.playing).toBe(false);
  });

  it("waits for a frame that is not here yet and skips nothing", () => {
    const player = playerWith([0, 0.1, 0.2]);
    player.play();
    for (let i = 0; i < 20; ++i) player.advance(0.05, () => false);
    expect(player.frame).toBe(0);
    for (let i = 0; i < 2; ++i) player.advance(0.05, () => true);
    expect(player.frame).toBe(1);
  });

  it("stays with the newest frame of sensors that are running, and leaves out what came late", () => {
    const player = playerWith([0, 0.1, 0.2]);
    player.live = true;
    player.play();
    player.advance(0.02, () => false);
    expect(player.frame).toBe(0);
    player.setTimes(3, new Float64Array([0.3, 0.4]));
    player.advance(0.02, () => true);
    expect(player.frame).toBe(2);
    player.advance(0.02, () => true);
    expect(player.frame).toBe(4);
    expect(player.playing).toBe(true);
    player.step(-3);
    player.advance(0.02, () => true);
    expect(player.frame).toBe(1);
  });

  it("keeps to its bounds when it steps", () => {
    const player = playerWith([0, 0.1, 0.2]);
    player.step(-5);
    expect(player.frame).toBe(0);
    player.step(Infinity);
    expect(player.frame).toBe(2);
  });

  it("takes stamps that come in parts, also again", () => {
    const player = playerWith([0, 0.1]);
    player.setTimes(2, new Float64Array([0.2, 0.3]));
    player.setTimes(2, new Float64Array([0.2, 0.3, 0.4]));
    expect(player.count).toBe(5);
    expect(player.duration).toBeCloseTo(0.4);
  });
});
