import * as THREE from "three";

import type { ThemeName } from "../palette";
import type { Frame } from "../protocol";
import type { ColourBy } from "../settings";
import { pointColours } from "./colours";

interface Cloud {
  points: THREE.Points;
  look: string;
  age: number;
}

/** The returns of the scan shown and of those kept before it, each a cloud of its own. */
export class PointLayer {
  readonly group = new THREE.Group();
  private readonly clouds = new Map<Frame, Cloud>();
  private readonly material = new THREE.PointsMaterial({ vertexColors: true, sizeAttenuation: false });

  /** `frames`: newest first. */
  show(frames: Frame[], by: ColourBy, theme: ThemeName, size: number, highlight: number): void {
    this.material.size = size;
    const wanted = new Set(frames);
    for (const [frame, cloud] of this.clouds) {
      if (wanted.has(frame)) continue;
      this.group.remove(cloud.points);
      cloud.points.geometry.dispose();
      this.clouds.delete(frame);
    }
    frames.forEach((frame, i) => {
      const age = frames.length > 1 ? i / (frames.length - 1) : 0;
      const marked = i === 0 ? highlight : 0;
      this.showOne(frame, `${by} ${theme} ${age.toFixed(2)} ${marked}`, () =>
        pointColours(frame, by, theme, age, marked),
      );
    });
  }

  private showOne(frame: Frame, look: string, colours: () => Uint8Array): void {
    let cloud = this.clouds.get(frame);
    if (!cloud) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(frame.positions, 3));
      const points = new THREE.Points(geometry, this.material);
      points.frustumCulled = false;
      cloud = { points, look: "", age: 0 };
      this.clouds.set(frame, cloud);
      this.group.add(points);
    }
    if (cloud.look === look) return;
    cloud.look = look;
    cloud.points.geometry.setAttribute("color", new THREE.BufferAttribute(colours(), 3, true));
  }
}
