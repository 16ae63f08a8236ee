// The JSON messages of the server and of the page.

import type { RunName } from "./protocol";

export interface Hello {
  op: "hello";
  protocol: number;
  title: string;
  preset: string;
  presets: string[];
  live: boolean;
  classes: string[];
  statuses: string[];
  labels_file: string;
}

export interface Oddity {
  what: string;
  count: number;
  first: string;
  damage: boolean;
}

export interface Status {
  op: "status";
  frames: number;
  done: boolean;
  problem: string;
  has_truth: boolean;
  events: number;
  confirmed: number;
  disk_bytes: number;
  sensors: string[];
  origin_m: [number, number, number];
  diagnostics: Oddity[];
  trial: number;
  trial_runs: boolean;
  trial_from?: number;
  trial_end?: number;
  trial_events?: number;
  trial_confirmed?: number;
}

export interface Option {
  section: string;
  name: string;
  value: string;
  fallback: string;
  range: string;
  doc: string;
  text: boolean;
}

export interface OptionsReply {
  op: "options";
  preset: string;
  options: Option[];
}

/** What `scanfuse evaluate --json` gives; see docs/metrics.md. */
export interface Metrics {
  frames: number;
  clear: Record<string, number | null>;
  identity: Record<string, number | null>;
  hota: Record<string, number | null>;
  gospa: Record<string, number | null>;
  rmse: Record<string, number | null>;
  ghosts_per_frame: number | null;
}

export interface MetricsReply {
  op: "metrics";
  from: number;
  end: number;
  main: Metrics | null;
  trial: Metrics | null;
}

export interface ExportReply {
  op: "export";
  run: RunName;
  toml: string;
}

export interface LabelObject {
  id: number;
  class: string;
  first: number;
  last: number;
  boxes: number;
}

export interface LabelBox {
  id: number;
  class: string;
  x: number;
  y: number;
  z: number;
  heading: number;
  length: number;
  width: number;
  height: number;
}

export interface LabelsReply {
  op: "labels";
  frame: number;
  objects: LabelObject[];
  boxes: LabelBox[];
  saved: boolean;
  can_undo: boolean;
  file: string;
  csv?: string;
}

export interface Problem {
  op: "problem";
  of: string;
  what: string;
}

export interface Missing {
  op: "missing";
  run: RunName;
  frame: number;
}

export type Told =
  | Hello | Status | OptionsReply | MetricsReply | ExportReply | LabelsReply | Problem | Missing;

export type Asked =
  | { op: "index"; run: RunName; from: number }
  | { op: "frame"; run: RunName; frame: number }
  | { op: "events"; run: RunName; from: number }
  | { op: "history"; run: RunName; track: number }
  | { op: "trails"; run: RunName; frame: number; length: number }
  | { op: "options"; preset?: string }
  | { op: "tune"; from: number; preset?: string; changes: string[] }
  | { op: "stop_tune" }
  | { op: "metrics" }
  | { op: "export"; run: RunName }
  | ({ op: "label"; action: string; frame: number } & Record<string, number | string>);
