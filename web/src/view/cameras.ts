import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

/** Two ways to look: from above without perspective, and freely in space. One set of controls. */
export class Cameras {
  readonly space = new THREE.PerspectiveCamera(50, 1, 0.1, 50000);
  readonly above = new THREE.OrthographicCamera(-1, 1, 1, -1, -20000, 20000);
  private readonly spaceControls: OrbitControls;
  private readonly aboveControls: OrbitControls;
  private isTop = false;
  private readonly target = new THREE.Vector3();

  constructor(element: HTMLElement, private readonly moved: () => void) {
    this.space.up.set(0, 0, 1);
    this.above.up.set(1, 0, 0);
    this.spaceControls = new OrbitControls(this.space, element);
    this.spaceControls.maxPolarAngle = Math.PI / 2 - 0.02;
    this.aboveControls = new OrbitControls(this.above, element);
    this.aboveControls.enableRotate = false;
    this.aboveControls.screenSpacePanning = true;
    this.aboveControls.mouseButtons = {
      LEFT: THREE.MOUSE.PAN, MIDDLE: THREE.MOUSE.DOLLY, RIGHT: THREE.MOUSE.PAN,
    };
    this.aboveControls.touches = { ONE: THREE.TOUCH.PAN, TWO: THREE.TOUCH.DOLLY_PAN };
    for (const controls of [this.spaceControls, this.aboveControls]) {
      controls.enableDamping = false;
      controls.zoomToCursor = true;
      controls.addEventListener("change", () => this.moved());
    }
    this.look(0, 0, 0, 40);
    this.setTop(false);
  }

  get camera(): THREE.Camera {
    return this.isTop ? this.above : this.space;
  }

  /** From what is looked at, as seen in space or as far as the top view shows. */
  get distance(): number {
    return this.isTop ? 1 / this.above.zoom : this.space.position.distanceTo(this.spaceControls.target);
  }

  set enabled(value: boolean) {
    this.spaceControls.enabled = value && !this.isTop;
    this.aboveControls.enabled = value && this.isTop;
  }

  setTop(top: boolean): void {
    this.isTop = top;
    this.enabled = true;
  }

  /** Looks at a place so that `radius` metres around it are in view. */
  look(x: number, y: number, z: number, radius: number): void {
    this.target.set(x, y, z);
    this.spaceControls.target.set(x, y, z);
    this.space.position.set(x - 0.95 * radius, y, z + 0.85 * radius);
    this.aboveControls.target.set(x, y, z);
    this.above.position.set(x, y, z + 500);
    this.above.zoom = 1 / radius;
    this.above.updateProjectionMatrix();
    this.spaceControls.update();
    this.aboveControls.update();
  }

  /** Moves along with something: everything else stays. */
  carry(dx: number, dy: number, dz: number): void {
    for (const controls of [this.spaceControls, this.aboveControls]) {
      controls.target.add(new THREE.Vector3(dx, dy, dz));
      controls.object.position.add(new THREE.Vector3(dx, dy, dz));
      controls.update();
    }
  }

  resize(width: number, height: number): void {
    const aspect = width / Math.max(1, height);
    this.space.aspect = aspect;
    this.space.updateProjectionMatrix();
    // The shorter side shows 1 / zoom to both sides.
    this.above.left = -Math.max(1, aspect);
    this.above.right = Math.max(1, aspect);
    this.above.top = Math.max(1, 1 / aspect);
    this.above.bottom = -Math.max(1, 1 / aspect);
    this.above.updateProjectionMatrix();
  }
}
