import * as THREE from "three";

const CELL_M = 10;
const CELLS = 16;

/** Lines every ten metres around the vehicle, every metre from near, every hundred or thousand from afar; in short pieces, which every renderer clips well. */
export class GroundGrid {
  readonly object: THREE.LineSegments;
  private readonly material = new THREE.LineBasicMaterial();

  constructor() {
    const points: number[] = [];
    for (let i = -CELLS; i <= CELLS; ++i) {
      for (let j = -CELLS; j < CELLS; ++j) {
        points.push(i, j, 0, i, j + 1, 0, j, i, 0, j + 1, i, 0);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points.map((v) => v * CELL_M), 3));
    this.object = new THREE.LineSegments(geometry, this.material);
    this.object.frustumCulled = false;
  }

  colour(hex: string): void {
    this.material.color.set(hex);
  }

  /** Stays on whole cells, so that the ground does not seem to move along. */
  centre(x: number, y: number, z: number, distance: number): void {
    const scale = distance < 20 ? 0.1 : distance < 300 ? 1 : distance < 3000 ? 10 : 100;
    const cell = scale * CELL_M;
    this.object.scale.set(scale, scale, 1);
    this.object.position.set(cell * Math.round(x / cell), cell * Math.round(y / cell), z - 0.02);
  }
}
