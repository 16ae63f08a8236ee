import * as THREE from "three";

import { PALETTES, rgb } from "../palette";
import { type Box, type Frame, RIG_PARTS, type Track } from "../protocol";
import type { LabelBox } from "../messages";
import type { Settings } from "../settings";
import { clusterOfTrack } from "./colours";
import { corners, drawnHeight, ellipse } from "./geometry";
import { LineLayer } from "./line_layer";
import { PointLayer } from "./point_layer";
import type { TrailMemory } from "./trail_memory";

const TENTATIVE = 0;
const COASTING = 2;
const TRAIL_FRAMES = 60;

/** A name that stands beside something in the scene. */
export interface Tag {
  text: string;
  x: number;
  y: number;
  z: number;
  colour: string;
  track: number | null;
  faint: boolean;
}

/** The scene of one run: everything that is drawn of a frame. */
export class Pane {
  readonly scene = new THREE.Scene();
  tags: Tag[] = [];
  frame: Frame | null = null;
  labels: LabelBox[] = [];
  private readonly points = new PointLayer();
  private readonly lines = new LineLayer("lines");
  private readonly pale = new LineLayer("lines", 0.45);
  private readonly faces = new LineLayer("faces", 0.2);

  constructor(private readonly settings: Settings, readonly trails: TrailMemory) {
    this.scene.add(this.points.group, this.faces.object, this.pale.object, this.lines.object);
  }

  /** `frames`: the one to show and those kept before it, newest first. */
  show(frames: Frame[]): void {
    const frame = frames[0];
    if (!frame) return;
    this.frame = frame;
    const { shown, colourBy, theme, pointSize, selected } = this.settings;
    this.points.group.visible = shown.points;
    this.points.show(frames, colourBy, theme, pointSize, clusterOfTrack(frame, selected));
    this.tags = [];
    for (const layer of [this.lines, this.pale, this.faces]) layer.begin();
    if (shown.outlines) this.drawOutlines(frame);
    if (shown.detections || isOfFixes(frame)) this.drawDetections(frame);
    if (shown.truth) this.drawTruth(frame);
    if (shown.boxes) for (const track of this.visibleTracks()) this.drawTrack(frame, track);
    if (shown.sight) this.drawSight(frame);
    if (frame.edges.length > 0) this.drawRig(frame);
    else if (frame.rays.length > 0) this.drawRays(frame);
    else this.drawSensor(frame);
    this.drawLabels();
    for (const layer of [this.lines, this.pale, this.faces]) layer.end();
  }

  visibleTracks(): Track[] {
    const { shown, selected } = this.settings;
    return (this.frame?.tracks ?? []).filter(
      (track) => shown.tentative || track.status !== TENTATIVE || track.id === selected,
    );
  }

  private get palette() {
    return PALETTES[this.settings.theme];
  }

  /** Ground level under what the sensor of a frame sees. */
  private ground(frame: Frame): number {
    return frame.egoPose.z;
  }

  private drawTrack(frame: Frame, track: Track): void {
    const isSelected = track.id === this.settings.selected;
    const hex = isSelected ? this.palette.selected : (this.palette.classes[track.class] ?? this.palette.text);
    const colour = rgb(hex);
    const faint = track.status === COASTING || track.status === TENTATIVE;
    const layer = faint ? this.pale : this.lines;
    const isPoint = track.length < 0.01;
    const low = isPoint ? track.z : this.ground(frame);
    const high = isPoint ? low : low + drawnHeight(track, track.class, sceneScale(track));
    if (isPoint) this.drawMark([track.x, track.y, low], this.markSize(frame), layer, colour);
    else this.drawBox(layer, track, low, high, colour, isSelected || !faint);
    const reach = Math.hypot(track.vx, track.vy);
    if (reach > 0.3) {
      const ahead = [track.x + track.vx, track.y + track.vy];
      layer.line([track.x, track.y], ahead, high, high, colour);
    }
    if (this.settings.shown.covariance || isSelected) {
      this.lines.loop(ellipse(track.x, track.y, track.covariance), low, colour);
    }
    if (this.settings.shown.trails) this.drawTrail(frame, track, colour, low);
    if (this.settings.shown.ids) {
      this.tags.push({ text: nameOf(track), x: track.x, y: track.y, z: high, colour: hex, track: track.id, faint: faint && !isSelected });
    }
  }

  private drawBox(
    layer: LineLayer,
    box: Box,
    low: number,
    high: number,
    colour: number[],
    filled: boolean,
  ): void {
    const around = corners(box);
    layer.loop(around, low, colour);
    layer.loop(around, high, colour);
    for (const corner of around) layer.line(corner, corner, low, high, colour);
    // The front is crossed, so that the heading shows.
    const [fl = [], bl = [], br = [], fr = []] = around as number[][];
    layer.line(fl, fr, low, high, colour);
    if (!filled) return;
    for (const corner of [fl, bl, br, fl, br, fr]) this.faces.point(corner[0] ?? 0, corner[1] ?? 0, low, colour);
  }

  private drawTrail(frame: Frame, track: Track, colour: number[], z: number): void {
    const trail = this.trails.of(track.id, frame.frame - TRAIL_FRAMES, frame.frame);
    for (let i = 1; i < trail.length; ++i) {
      const a = trail[i - 1];
      const b = trail[i];
      if (a && b) this.pale.line([a.x, a.y], [b.x, b.y], z, z, colour);
    }
  }

  private drawOutlines(frame: Frame): void {
    const z = frame.sensorPose.z;
    const colour = rgb(this.palette.text);
    for (const line of frame.lines) {
      this.pale.line([line.x0, line.y0], [line.x1, line.y1], z, z, colour);
    }
  }

  private drawDetections(frame: Frame): void {
    const z = this.ground(frame);
    for (const detection of frame.detections) {
      const colour = rgb(this.palette.classes[detection.class] ?? this.palette.text);
      const isPoint = detection.length < 0.01;
      if (isPoint) this.drawMark([detection.x, detection.y, detection.z], this.markSize(frame), this.lines, colour);
      else this.pale.loop(corners(detection), z, colour);
      if (this.settings.shown.covariance || isPoint) {
        this.pale.loop(ellipse(detection.x, detection.y, detection.covariance), z, colour);
      }
    }
  }

  private drawTruth(frame: Frame): void {
    const z = this.ground(frame);
    const colour = rgb(this.palette.truth);
    for (const object of frame.truth) {
      const around = corners(object);
      // Dashed, so that it is told from tracks without colour.
      around.forEach((p, i) => dashes(this.lines, p, around[(i + 1) % 4] ?? p, z, colour));
    }
  }

  private drawSensor(frame: Frame): void {
    const colour = rgb(this.palette.accent);
    const { x, y, heading } = frame.egoPose;
    const z = this.ground(frame);
    const place = frame.sensorPose;
    const turn = (a: number, d: number) => [x + d * Math.cos(heading + a), y + d * Math.sin(heading + a)];
    const size = Math.max(0.1, Math.min(1, reachOf(frame) / 25)); // no larger than what is around it
    this.lines.loop([turn(0, 1.5 * size), turn(2.5, size), turn(Math.PI, 0.5 * size), turn(-2.5, size)], z, colour);
    this.lines.line([place.x, place.y], [place.x, place.y], z, place.z, colour);
  }

  private drawSight(frame: Frame): void {
    const from = frame.sensorPose;
    const colour = rgb(this.palette.accent);
    for (const track of this.visibleTracks()) {
      this.pale.line([from.x, from.y], [track.x, track.y], from.z, from.z, colour);
    }
  }

  /** Lines of sight, and a mark for each sensor that tells directions only. */
  private drawRays(frame: Frame): void {
    const size = this.markSize(frame);
    const marked = new Set<number>();
    for (const ray of frame.rays) {
      const colour = rgb(ray.target < 0 ? this.palette.noise : this.palette.accent);
      this.pale.line(ray.from, ray.to, ray.from[2], ray.to[2], colour);
      if (marked.has(ray.sensor)) continue;
      marked.add(ray.sensor);
      this.drawMark(ray.from, 1.5 * size, this.lines, rgb(this.palette.text));
      const [x, y, z] = ray.from;
      this.tags.push({ text: `sensor ${ray.sensor + 1}`, x, y, z, colour: this.palette.text, track: null, faint: false });
    }
  }

  /** A turntable's rig: camera, axis, lidar as it stands now, boards; a name at each. */
  private drawRig(frame: Frame): void {
    const { text, accent, warning, noise } = this.palette;
    const colours = [text, accent, warning, noise];
    const named = new Set<number>();
    for (const { from, to, part } of frame.edges) {
      const colour = colours[part] ?? text;
      this.lines.line(from, to, from[2], to[2], rgb(colour));
      if (named.has(part)) continue;
      named.add(part);
      const [x, y, z] = from;
      this.tags.push({ text: RIG_PARTS[part] ?? "", x, y, z, colour, track: null, faint: false });
    }
  }

  private drawMark([x, y, z]: [number, number, number], r: number, layer: LineLayer, colour: number[]): void {
    layer.loop([[x + r, y], [x, y + r], [x - r, y], [x, y - r]], z, colour);
    layer.line([x, y], [x, y], z - r, z + r, colour);
  }

  /** What is but a point is drawn so that it can be seen from where all can. */
  private markSize(frame: Frame): number {
    const reach = Math.max(10, ...frame.rays.map((r) => Math.hypot(r.to[0] - r.from[0], r.to[1] - r.from[1])));
    return reach / 80;
  }

  private drawLabels(): void {
    const frame = this.frame;
    if (!frame) return;
    const z = this.ground(frame);
    const colour = rgb(this.palette.warning);
    for (const label of this.labels) {
      this.lines.loop(corners(label), z + 0.02, colour);
      this.lines.loop(corners({ ...label, length: label.length + 0.15, width: label.width + 0.15 }), z + 0.02, colour);
      this.tags.push({ text: `object ${label.id}`, x: label.x, y: label.y, z, colour: this.palette.warning, track: null, faint: false });
    }
  }
}

/** Directions that were intersected, scan by scan: there is nothing else to see. */
function isOfFixes(frame: Frame): boolean {
  return frame.rays.length > 0 && frame.tracks.length === 0;
}

export function nameOf(track: Track): string {
  const letters = ["", "car", "person", "cyclist", "other"];
  return `${track.id} ${letters[track.class] ?? ""}${track.status === TENTATIVE ? " (new)" : ""}`;
}

/** Within which half of the returns lie, from a few of them. */
function reachOf(frame: Frame): number {
  const distances: number[] = [];
  const stride = 3 * Math.max(1, Math.floor(frame.positions.length / 300));
  for (let i = 0; i < frame.positions.length; i += stride) {
    distances.push(Math.hypot((frame.positions[i] ?? 0) - frame.egoPose.x, (frame.positions[i + 1] ?? 0) - frame.egoPose.y));
  }
  return distances.sort((a, b) => a - b)[distances.length >> 1] ?? 25;
}

/** Models of 1:10 are drawn lower than cars. */
function sceneScale(track: Track): number {
  return track.class === 1 && track.length < 1.5 ? track.length / 4.5 : 1;
}

function dashes(layer: LineLayer, a: number[], b: number[], z: number, colour: number[]): void {
  const length = Math.hypot((b[0] ?? 0) - (a[0] ?? 0), (b[1] ?? 0) - (a[1] ?? 0));
  const count = Math.max(3, 2 * Math.round(length / 0.5) + 1);
  for (let i = 0; i < count; i += 2) {
    const at = (t: number) => [
      (a[0] ?? 0) + t * ((b[0] ?? 0) - (a[0] ?? 0)),
      (a[1] ?? 0) + t * ((b[1] ?? 0) - (a[1] ?? 0)),
    ];
    layer.line(at(i / count), at((i + 1) / count), z, z, colour);
  }
}
