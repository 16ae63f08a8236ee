import * as THREE from "three";

import { h } from "../dom";
import { PALETTES } from "../palette";
import type { Pose } from "../model";
import type { Frame, Track } from "../protocol";
import type { Settings } from "../settings";
import { Signal } from "../signal";
import { Cameras } from "./cameras";
import { contains } from "./geometry";
import { GroundGrid } from "./ground_grid";
import { Pane } from "./pane";
import { TagOverlay } from "./tags";
import { TrailMemory } from "./trail_memory";

/** The picture: one pane, or two side by side that are looked at by one camera. */
export class Stage {
  readonly element = h("div", { class: "stage", tabindex: "0", role: "application", "aria-label": "Scene; arrow keys step through the recording" });
  readonly picked = new Signal<Track | null>();
  readonly dragged = new Signal<{ x: number; y: number; done: boolean }>();
  readonly panes: [Pane, Pane];
  /** Set by the labels: whether a press at a place begins to drag something. */
  grabs: (x: number, y: number) => boolean = () => false;
  frameTimes: number[] = [];
  private readonly renderer: THREE.WebGLRenderer;
  private readonly cameras: Cameras;
  private readonly tags = new TagOverlay();
  private readonly grid = new GroundGrid();
  private dirty = true;
  private width = 1;
  private height = 1;
  private followed: { id: number | null; x: number; y: number; ego: Pose } | null = null;
  private placed = false;

  constructor(private readonly settings: Settings) {
    this.panes = [new Pane(settings, new TrailMemory()), new Pane(settings, new TrailMemory())];
    // Colours are given as they are to be seen; nothing is lit.
    THREE.ColorManagement.enabled = false;
    this.renderer = new THREE.WebGLRenderer({ antialias: !isDrawnInSoftware() });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setScissorTest(true);
    this.renderer.autoClear = false;
    this.element.append(this.renderer.domElement, this.tags.element);
    this.cameras = new Cameras(this.renderer.domElement, () => this.redraw());
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.listen();
  }

  redraw(): void {
    this.dirty = true;
  }

  /** What the settings changed. */
  restyle(): void {
    this.cameras.setTop(this.settings.view === "top");
    this.grid.colour(PALETTES[this.settings.theme].grid);
    this.resize();
  }

  show(pane: 0 | 1, frames: Frame[]): void {
    const frame = frames[0];
    if (!frame) return;
    this.panes[pane].show(frames);
    if (pane === 0) this.follow(frame);
    this.redraw();
  }

  /** Looks at the whole scan, or at the selected track. */
  fit(): void {
    const frame = this.panes[0].frame;
    if (!frame) return;
    const track = frame.tracks.find((one) => one.id === this.settings.selected);
    const all = extentOf(frame);
    if (track) this.cameras.look(track.x, track.y, frame.egoPose.z, 12);
    else this.cameras.look(all.x, all.y, frame.egoPose.z, all.reach);
    this.redraw();
  }

  /** Draws if anything changed; call once a frame of the screen. */
  draw(): void {
    if (!this.dirty) return;
    this.dirty = false;
    const before = performance.now();
    const split = this.settings.compare;
    const width = split ? this.width / 2 : this.width;
    this.tags.begin();
    this.cameras.resize(width, this.height);
    this.renderer.setClearColor(PALETTES[this.settings.theme].ground);
    for (const [i, pane] of this.panes.entries()) {
      if (i === 1 && !split) break;
      pane.scene.add(this.grid.object);
      this.renderer.setViewport(i * width, 0, width, this.height);
      this.renderer.setScissor(i * width, 0, width, this.height);
      this.renderer.clear();
      this.renderer.render(pane.scene, this.cameras.camera);
      this.tags.place(pane.tags, this.cameras.camera, i * width, width, this.height, this.settings.selected);
    }
    this.tags.end();
    this.frameTimes.push(performance.now() - before);
    if (this.frameTimes.length > 600) this.frameTimes.shift();
  }

  /** Where a track stands in the page; for tests. */
  placeOf(id: number): { x: number; y: number } | null {
    const track = this.panes[0].frame?.tracks.find((one) => one.id === id);
    if (!track) return null;
    const at = new THREE.Vector3(track.x, track.y, track.z).project(this.cameras.camera);
    const box = this.renderer.domElement.getBoundingClientRect();
    const width = this.settings.compare ? this.width / 2 : this.width;
    return { x: box.left + (width * (at.x + 1)) / 2, y: box.top + (this.height * (1 - at.y)) / 2 };
  }

  private follow(frame: Frame): void {
    if (!this.placed && frame.positions.length + frame.rays.length > 0) {
      this.placed = true;
      this.fit();
    }
    const selected = frame.tracks.find((one) => one.id === this.settings.selected);
    const { x, y } = selected ?? frame.egoPose;
    const id = selected?.id ?? null;
    const { ego, ...last } = this.followed ?? { ego: null };
    if (this.settings.follow && ego) {
      // Another one to follow: the vehicle tells how far the scene went on meanwhile.
      const from = "id" in last && last.id === id ? last : ego;
      const to = from === ego ? frame.egoPose : { x, y };
      this.cameras.carry(to.x - from.x, to.y - from.y, frame.egoPose.z - ego.z);
    }
    this.followed = { id, x, y, ego: frame.egoPose };
    this.grid.centre(frame.egoPose.x, frame.egoPose.y, frame.egoPose.z, this.cameras.distance);
  }

  private resize(): void {
    this.width = Math.max(1, this.element.clientWidth);
    this.height = Math.max(1, this.element.clientHeight);
    this.renderer.setSize(this.width, this.height);
    this.redraw();
  }

  private listen(): void {
    const canvas = this.renderer.domElement;
    let pressed: { x: number; y: number; drags: boolean } | null = null;
    canvas.addEventListener("pointerdown", (event) => {
      const place = this.groundAt(event);
      const drags = place !== null && this.grabs(place.x, place.y);
      pressed = { x: event.clientX, y: event.clientY, drags };
      this.cameras.enabled = !drags;
    }, { capture: true });
    canvas.addEventListener("pointermove", (event) => {
      const place = pressed?.drags ? this.groundAt(event) : null;
      if (place) this.dragged.emit({ ...place, done: false });
    });
    canvas.addEventListener("pointerup", (event) => {
      const place = this.groundAt(event);
      if (pressed?.drags && place) this.dragged.emit({ ...place, done: true });
      else if (pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < 5) {
        this.picked.emit(place ? this.trackAt(place.x, place.y, place.pane) : null);
      }
      pressed = null;
      this.cameras.enabled = true;
    });
  }

  private groundAt(event: PointerEvent): { x: number; y: number; pane: 0 | 1 } | null {
    const box = this.renderer.domElement.getBoundingClientRect();
    const split = this.settings.compare;
    const width = split ? box.width / 2 : box.width;
    const pane = split && event.clientX - box.left > width ? 1 : 0;
    const x = (2 * (event.clientX - box.left - pane * width)) / width - 1;
    const y = 1 - (2 * (event.clientY - box.top)) / box.height;
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(x, y), this.cameras.camera);
    const level = (this.panes[pane].frame?.egoPose.z ?? 0) + (this.settings.view === "top" ? 0 : 0.5);
    const hit = ray.ray.intersectPlane(new THREE.Plane(new THREE.Vector3(0, 0, 1), -level), new THREE.Vector3());
    return hit && { x: hit.x, y: hit.y, pane };
  }

  /** The nearest track whose box, a little grown, holds the place. */
  private trackAt(x: number, y: number, pane: 0 | 1): Track | null {
    let best: Track | null = null;
    let nearest = Infinity;
    const margin = Math.max(0.6, 0.02 * this.cameras.distance);
    for (const track of this.panes[pane].visibleTracks()) {
      const distance = Math.hypot(track.x - x, track.y - y);
      if (contains(track, x, y, margin) && distance < nearest) {
        best = track;
        nearest = distance;
      }
    }
    return best;
  }
}

/** Without a graphics card smooth edges would more than double what a frame costs. */
function isDrawnInSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl && names ? String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/** The middle of the returns and the reach within which most of them lie. */
function extentOf(frame: Frame): { x: number; y: number; reach: number } {
  const stride = 3 * Math.max(1, Math.floor(frame.positions.length / 9000));
  const xs: number[] = [];
  const ys: number[] = [];
  for (let i = 0; i < frame.positions.length; i += stride) {
    xs.push(frame.positions[i] ?? 0);
    ys.push(frame.positions[i + 1] ?? 0);
  }
  for (const { from, to } of frame.rays) {
    xs.push(from[0], to[0]);
    ys.push(from[1], to[1]);
  }
  xs.push(frame.egoPose.x);
  ys.push(frame.egoPose.y);
  const at = (values: number[], share: number) => values[Math.floor(share * (values.length - 1))] ?? 0;
  for (const values of [xs, ys]) values.sort((a, b) => a - b);
  const [x0, x1, y0, y1] = [at(xs, 0.03), at(xs, 0.9), at(ys, 0.05), at(ys, 0.95)];
  const left = Math.min(x0, frame.egoPose.x);
  const x = (left + Math.max(x1, frame.egoPose.x)) / 2;
  const y = (y0 + y1) / 2;
  const reach = Math.max(x1 - x, x - left, (y1 - y0) / 2);
  return { x, y, reach: Math.max(3, Math.min(frame.rays.length > 0 ? Infinity : 60, 1.15 * reach)) };
}
