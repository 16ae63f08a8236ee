import * as THREE from "three";

/** Coloured lines, or triangles, that are all drawn anew for every frame. Grows as it must. */
export class LineLayer {
  readonly object: THREE.LineSegments | THREE.Mesh;
  private readonly geometry = new THREE.BufferGeometry();
  private positions = new Float32Array(3 * 1024);
  private colours = new Uint8Array(3 * 1024);
  private count = 0;

  constructor(kind: "lines" | "faces", opacity = 1) {
    const look = { vertexColors: true, transparent: opacity < 1, opacity, depthWrite: opacity >= 1 };
    this.object = kind === "lines"
      ? new THREE.LineSegments(this.geometry, new THREE.LineBasicMaterial(look))
      : new THREE.Mesh(
          this.geometry,
          new THREE.MeshBasicMaterial({ ...look, side: THREE.DoubleSide }),
        );
    this.object.frustumCulled = false;
    this.attach();
  }

  begin(): void {
    this.count = 0;
  }

  point(x: number, y: number, z: number, [r, g, b]: readonly number[]): void {
    if (3 * (this.count + 1) > this.positions.length) this.grow();
    const i = 3 * this.count++;
    this.positions[i] = x;
    this.positions[i + 1] = y;
    this.positions[i + 2] = z;
    this.colours[i] = r ?? 0;
    this.colours[i + 1] = g ?? 0;
    this.colours[i + 2] = b ?? 0;
  }

  line(a: readonly number[], b: readonly number[], za: number, zb: number, colour: readonly number[]): void {
    this.point(a[0] ?? 0, a[1] ?? 0, za, colour);
    this.point(b[0] ?? 0, b[1] ?? 0, zb, colour);
  }

  /** A closed line at one height. */
  loop(points: readonly (readonly number[])[], z: number, colour: readonly number[]): void {
    points.forEach((p, i) => this.line(p, points[(i + 1) % points.length] ?? p, z, z, colour));
  }

  end(): void {
    this.geometry.setDrawRange(0, this.count);
    (this.geometry.attributes["position"] as THREE.BufferAttribute).needsUpdate = true;
    (this.geometry.attributes["color"] as THREE.BufferAttribute).needsUpdate = true;
  }

  private grow(): void {
    const positions = new Float32Array(2 * this.positions.length);
    const colours = new Uint8Array(2 * this.colours.length);
    positions.set(this.positions);
    colours.set(this.colours);
    this.positions = positions;
    this.colours = colours;
    this.attach();
  }

  private attach(): void {
    this.geometry.dispose();
    this.geometry.setAttribute("position", new THREE.BufferAttribute(this.positions, 3));
    this.geometry.setAttribute("color", new THREE.BufferAttribute(this.colours, 3, true));
  }
}
