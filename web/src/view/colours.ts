import { PALETTES, ramp, rgb, SEGMENT_COLOURS, type ThemeName } from "../palette";
import type { Frame } from "../protocol";
import type { ColourBy } from "../settings";

/**
 * A colour for each return of a frame, three bytes each. `age` is that of the whole scan, 0 (new)
 * to 1; `highlight` is the cluster whose returns stand out, 0 for none.
 */
export function pointColours(
  frame: Frame,
  by: ColourBy,
  theme: ThemeName,
  age: number,
  highlight: number,
): Uint8Array {
  const count = frame.clusters.length;
  const colours = new Uint8Array(3 * count);
  const table = colourTable(frame, by, theme, age);
  const selected = rgb(PALETTES[theme].selected);
  const ground = rgb(PALETTES[theme].ground);
  const fade = by === "age" ? 0 : 0.75 * age;
  for (let i = 0; i < count; ++i) {
    const colour = highlight > 0 && frame.clusters[i] === highlight ? selected : table(i);
    for (let c = 0; c < 3; ++c) {
      colours[3 * i + c] = (colour[c] ?? 0) * (1 - fade) + (ground[c] ?? 0) * fade;
    }
  }
  return colours;
}

type Rgb = readonly number[];

function colourTable(
  frame: Frame,
  by: ColourBy,
  theme: ThemeName,
  age: number,
): (index: number) => Rgb {
  const noise: Rgb = rgb(PALETTES[theme].noise);
  const ramps: Rgb[] = Array.from({ length: 256 }, (_, i) => ramp(i / 255, theme));
  const shade = (byte: number): Rgb => ramps[Math.max(0, Math.min(255, byte | 0))] ?? noise;
  switch (by) {
    case "segment": {
      const segments: Rgb[] = SEGMENT_COLOURS[theme].map(rgb);
      return (i) => {
        const cluster = frame.clusters[i] ?? 0;
        return cluster === 0 ? noise : (segments[cluster % segments.length] ?? noise);
      };
    }
    case "class": {
      const classes: Rgb[] = PALETTES[theme].classes.map(rgb);
      const ofCluster = classOfCluster(frame);
      return (i) => {
        const found = ofCluster[frame.clusters[i] ?? 0] ?? -1;
        return found < 0 ? noise : (classes[found] ?? noise);
      };
    }
    case "intensity":
      return (i) => shade(frame.intensities[i] ?? 0);
    case "layer": {
      const top = Math.max(1, frame.layers.reduce((a, b) => Math.max(a, b), 0));
      return (i) => shade((255 * (frame.layers[i] ?? 0)) / top);
    }
    case "height": {
      const base = frame.sensorPose.z - 2;
      return (i) => shade(((frame.positions[3 * i + 2] ?? 0) - base) * 64);
    }
    case "age":
      return () => shade(255 * (1 - age));
  }
}

/** By cluster label (1 + its number): the class of its track, else of its detection; -1: none. */
export function classOfCluster(frame: Frame): Int8Array {
  const trackOf = new Map(frame.tracks.map((track) => [track.detection, track]));
  const classes = new Int8Array(frame.detectionOfCluster.length + 1).fill(-1);
  frame.detectionOfCluster.forEach((detection, cluster) => {
    if (detection < 0) return;
    classes[cluster + 1] =
      trackOf.get(detection)?.class ?? frame.detections[detection]?.class ?? -1;
  });
  return classes;
}

/** The label of the cluster that supports a track at this frame; 0 when none does. */
export function clusterOfTrack(frame: Frame, id: number | null): number {
  const track = frame.tracks.find((one) => one.id === id);
  if (!track || track.detection < 0) return 0;
  return frame.detectionOfCluster.indexOf(track.detection) + 1;
}
