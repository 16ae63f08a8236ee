import * as THREE from "three";

import { h } from "../dom";
import { PALETTES } from "../palette";
import type { Frame, Track } from "../protocol";
import type { Settings } from "../settings";
import { Signal } from "../signal";
import { Cameras } from "./cameras";
import { contains } from "./geometry";
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
  private readonly grid = new THREE.Group();
  private dirty = true;
  private width = 1;
  private height = 1;
  private followed: { x: number; y: number; z: number } | null = null;
  private placed = false;

  constructor(private readonly settings: Settings) {
    this.panes = [new Pane(settings, new TrailMemory()), new Pane(settings, new TrailMemory())];
    this.renderer = new THREE.WebGLRenderer({ antialias: true });
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
    this.makeGrid();
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
    const { x, y, z } = track ?? frame.egoPose;
    this.cameras.look(x, y, frame.egoPose.z, track ? 12 : reachOf(frame));
    this.followed = { x, y, z };
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
      pane.scene.add(this.grid);
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
    if (!this.placed && frame.positions.length > 0) {
      this.placed = true;
      this.fit();
      return;
    }
    const selected = frame.tracks.find((one) => one.id === this.settings.selected);
    const now = selected ?? frame.egoPose;
    const target = { x: now.x, y: now.y, z: frame.egoPose.z };
    if (this.settings.follow && this.followed) {
      const { x, y, z } = this.followed;
      const far = Math.hypot(target.x - x, target.y - y) > 30;
      if (!far || !selected) this.cameras.carry(target.x - x, target.y - y, target.z - z);
    }
    this.followed = target;
  }

  private resize(): void {
    this.width = Math.max(1, this.element.clientWidth);
    this.height = Math.max(1, this.element.clientHeight);
    this.renderer.setSize(this.width, this.height);
    this.redraw();
  }

  private makeGrid(): void {
    this.grid.clear();
    const colour = new THREE.Color(PALETTES[this.settings.theme].grid);
    const lines = new THREE.GridHelper(400, 40, colour, colour);
    lines.rotation.x = Math.PI / 2;
    this.grid.add(lines);
    this.grid.position.z = (this.panes[0].frame?.egoPose.z ?? 0) - 0.02;
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
    for (const track of this.panes[pane].visibleTracks()) {
      const distance = Math.hypot(track.x - x, track.y - y);
      if (contains(track, x, y, 0.6) && distance < nearest) {
        best = track;
        nearest = distance;
      }
    }
    return best;
  }
}

/** Within which most returns lie, and the tracks. */
function reachOf(frame: Frame): number {
  const distances: number[] = [];
  const stride = 3 * Math.max(1, Math.floor(frame.positions.length / 3000));
  for (let i = 0; i < frame.positions.length; i += stride) {
    const dx = (frame.positions[i] ?? 0) - frame.egoPose.x;
    const dy = (frame.positions[i + 1] ?? 0) - frame.egoPose.y;
    distances.push(Math.hypot(dx, dy));
  }
  distances.sort((a, b) => a - b);
  const typical = distances[Math.floor(0.8 * distances.length)] ?? 20;
  return Math.max(4, Math.min(60, 1.1 * typical));
}
