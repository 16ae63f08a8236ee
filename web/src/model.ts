// What a frame, a track, an event is, as the server tells it.

export const PROTOCOL = "scanfuse.viewer.v1";
export type RunName = 0 | 1;
export const MAIN: RunName = 0;
export const TRIAL: RunName = 1;

export interface Box {
  x: number;
  y: number;
  z: number;
  heading: number;
  length: number;
  width: number;
  height: number;
}

export interface Detection extends Box {
  covariance: [number, number, number];
  score: number;
  class: number;
  points: number;
}

export interface Track extends Box {
  id: number;
  vx: number;
  vy: number;
  covariance: [number, number, number];
  speed: number;
  accel: number;
  yawRate: number;
  classProbability: number;
  movingProbability: number;
  nis: number;
  detection: number;
  age: number;
  missed: number;
  class: number;
  status: number;
}

export interface TruthObject extends Box {
  id: number;
  class: number;
}

export interface Pose {
  x: number;
  y: number;
  z: number;
  heading: number;
}

export interface Line {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
  cluster: number;
}

/** A straight line of a turntable's rig. */
export interface Edge {
  from: [number, number, number];
  to: [number, number, number];
  part: number;
}
export const RIG_PARTS = ["camera", "axis", "lidar", "board"] as const;

export interface Ray {
  from: [number, number, number];
  to: [number, number, number];
  sensor: number;
  target: number;
}

export interface Frame {
  run: RunName;
  frame: number;
  time: number;
  number: number;
  sensor: number;
  sensorPose: Pose;
  egoPose: Pose;
  intensityLow: number;
  intensityHigh: number;
  positions: Float32Array;
  clusters: Uint16Array;
  layers: Uint8Array;
  intensities: Uint8Array;
  detectionOfCluster: Int32Array;
  lines: Line[];
  detections: Detection[];
  tracks: Track[];
  truth: TruthObject[];
  rays: Ray[];
  edges: Edge[];
}

export interface IndexPart {
  run: RunName;
  from: number;
  times: Float64Array;
}

export interface TrackEvent {
  track: number;
  frame: number;
  kind: number;
}
export const EVENT_NAMES = ["birth", "coast", "loss", "switch"] as const;

export interface EventsPart {
  run: RunName;
  from: number;
  events: TrackEvent[];
}

export interface HistorySample extends Track {
  time: number;
  frame: number;
}

export interface History {
  run: RunName;
  track: number;
  samples: HistorySample[];
}

export interface TrailPoint {
  id: number;
  frame: number;
  x: number;
  y: number;
}

export type Binary =
  | ({ kind: "frame" } & Frame)
  | ({ kind: "index" } & IndexPart)
  | ({ kind: "events" } & EventsPart)
  | ({ kind: "history" } & History)
  | { kind: "trails"; run: RunName; points: TrailPoint[] };
