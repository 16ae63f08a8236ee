import { describe, expect, it } from "vitest";

import { bounds } from "../src/panels/options_form";
import { classOfCluster, clusterOfTrack, pointColours } from "../src/view/colours";
import { contains, corners, ellipse } from "../src/view/geometry";
import { TrailMemory } from "../src/view/trail_memory";
import { COLOUR_BY } from "../src/settings";
import { sampleFrame } from "./sample";

describe("geometry", () => {
  const box = { x: 1, y: 2, z: 0, heading: Math.PI / 2, length: 4, width: 2, height: 0 };

  it("puts the corners around the centre, the front first", () => {
    expect(corners(box)[0]?.map((v) => Math.round(v))).toEqual([0, 4]);
    const mean = corners(box).reduce(([a, b], [x, y]) => [a + x / 4, b + y / 4], [0, 0]);
    expect(mean[0]).toBeCloseTo(1);
    expect(mean[1]).toBeCloseTo(2);
  });

  it("knows what lies inside", () => {
    expect(contains(box, 1, 3.9, 0)).toBe(true);
    expect(contains(box, 2.9, 2, 0)).toBe(false);
    expect(contains(box, 2.9, 2, 1)).toBe(true);
  });

  it("draws the ellipse whose Mahalanobis distance is that of 95 %", () => {
    const [xx, xy, yy] = [0.5, 0.2, 0.3] as const;
    const determinant = xx * yy - xy * xy;
    for (const [x, y] of ellipse(1, 2, [xx, xy, yy])) {
      const [dx, dy] = [x - 1, y - 2];
      const square = (yy * dx * dx - 2 * xy * dx * dy + xx * dy * dy) / determinant;
      expect(square).toBeCloseTo(5.991, 6);
    }
  });
});

describe("colours", () => {
  const frame = sampleFrame(0, 0, 6);

  it("gives every return a colour in each way of colouring", () => {
    for (const by of COLOUR_BY) {
      const colours = pointColours(frame, by, "dark", 0, 0);
      expect(colours).toHaveLength(18);
      expect(colours.some((v) => v > 0)).toBe(true);
    }
  });

  it("tells returns of a cluster from those in none", () => {
    const colours = pointColours(frame, "segment", "dark", 0, 0);
    expect([...colours.slice(0, 3)]).not.toEqual([...colours.slice(3, 6)]);
    expect([...colours.slice(0, 3)]).toEqual([...colours.slice(6, 9)]);
  });

  it("finds which returns support a track, and their class", () => {
    expect(clusterOfTrack(frame, 42)).toBe(1);
    expect(clusterOfTrack(frame, 43)).toBe(0);
    expect([...classOfCluster(frame)]).toEqual([-1, 1]);
  });
});

describe("TrailMemory", () => {
  it("gives trails in order, however frames came", () => {
    const trails = new TrailMemory();
    for (const frame of [5, 3, 4, 9]) trails.add(sampleFrame(0, frame));
    trails.addMany([{ id: 42, frame: 4, x: 0, y: 0 }, { id: 42, frame: 2, x: 0, y: 0 }]);
    expect(trails.of(42, 0, 5).map((p) => p.frame)).toEqual([2, 3, 4, 5]);
    expect(trails.of(42, 4, 9).map((p) => p.frame)).toEqual([4, 5, 9]);
    expect(trails.knows(2, 5)).toBe(true);
    expect(trails.knows(2, 6)).toBe(false);
  });
});

describe("bounds", () => {
  it("reads the range of a number and of nothing else", () => {
    expect(bounds("0.01 .. 10")).toEqual([0.01, 10]);
    expect(bounds("-1e-3 .. 1e6")).toEqual([-0.001, 1e6]);
    expect(bounds("pag | euclidean")).toBeNull();
    expect(bounds("")).toBeNull();
  });
});
