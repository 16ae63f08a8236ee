import * as THREE from "three";

import { h } from "../dom";
import type { Tag } from "./pane";

const MOST_TAGS = 60;

/** Names over the scene, as text of the page: sharp at any size, and readable by screen readers. */
export class TagOverlay {
  readonly element = h("div", { class: "tags", "aria-hidden": "true" });
  private readonly pool: HTMLSpanElement[] = [];
  private used = 0;

  begin(): void {
    this.used = 0;
  }

  /** Within a part of the view, given in pixels. */
  place(tags: Tag[], camera: THREE.Camera, left: number, width: number, height: number, selected: number | null): void {
    const at = new THREE.Vector3();
    for (const tag of tags) {
      if (this.used >= MOST_TAGS) return;
      at.set(tag.x, tag.y, tag.z).project(camera);
      if (Math.abs(at.x) > 1 || Math.abs(at.y) > 1 || at.z > 1 || at.z < -1) continue;
      const x = left + (width * (at.x + 1)) / 2;
      const y = (height * (1 - at.y)) / 2;
      const span = this.next();
      if (span.textContent !== tag.text) span.textContent = tag.text;
      span.style.transform = `translate(${x.toFixed(0)}px, ${(y - 18).toFixed(0)}px)`;
      span.style.color = tag.colour;
      span.classList.toggle("faint", tag.faint);
      span.classList.toggle("selected", tag.track !== null && tag.track === selected);
    }
  }

  end(): void {
    for (let i = this.used; i < this.pool.length; ++i) {
      const span = this.pool[i];
      if (span) span.hidden = true;
    }
  }

  private next(): HTMLSpanElement {
    let span = this.pool[this.used];
    if (!span) {
      span = h("span", { class: "tag" });
      this.pool.push(span);
      this.element.append(span);
    }
    span.hidden = false;
    ++this.used;
    return span;
  }
}
