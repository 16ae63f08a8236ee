import type { Box } from "../protocol";

/** Heights for drawing what tells none, by class: unknown, vehicle, pedestrian, cyclist, other. */
const DRAWN_HEIGHT_M = [1, 1.5, 1.7, 1.7, 1];

export function drawnHeight(box: Box, objectClass: number, scale: number): number {
  return box.height > 0 ? box.height : scale * (DRAWN_HEIGHT_M[objectClass] ?? 1);
}

/** The corners from above, counter-clockwise from the front left. */
export function corners(box: Box): [number, number][] {
  const c = Math.cos(box.heading);
  const s = Math.sin(box.heading);
  const l = box.length / 2;
  const w = box.width / 2;
  return ([[l, w], [-l, w], [-l, -w], [l, -w]] as const).map(([x, y]) => [
    box.x + c * x - s * y,
    box.y + s * x + c * y,
  ]);
}

/** Whether a point from above lies in the box, grown by `margin`. */
export function contains(box: Box, x: number, y: number, margin: number): boolean {
  const c = Math.cos(box.heading);
  const s = Math.sin(box.heading);
  const dx = x - box.x;
  const dy = y - box.y;
  return (
    Math.abs(c * dx + s * dy) <= box.length / 2 + margin &&
    Math.abs(c * dy - s * dx) <= box.width / 2 + margin
  );
}

/** Points on the ellipse that holds 95 % of a planar Gaussian. */
export function ellipse(
  x: number,
  y: number,
  [xx, xy, yy]: readonly [number, number, number],
  count = 36,
): [number, number][] {
  const RADIUS = Math.sqrt(5.991); // chi-square, 2 degrees of freedom
  const mean = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  const major = RADIUS * Math.sqrt(Math.max(0, mean + spread));
  const minor = RADIUS * Math.sqrt(Math.max(0, mean - spread));
  const turn = Math.atan2(2 * xy, xx - yy) / 2;
  const c = Math.cos(turn);
  const s = Math.sin(turn);
  return Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    const p = major * Math.cos(angle);
    const q = minor * Math.sin(angle);
    return [x + c * p - s * q, y + s * p + c * q];
  });
}
