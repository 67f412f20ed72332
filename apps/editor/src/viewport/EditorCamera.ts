import type { CameraComponent } from '@farol/engine';
import CameraControls from 'camera-controls';
import {
  Box3,
  type Camera,
  MathUtils,
  Matrix4,
  PerspectiveCamera,
  Quaternion,
  Raycaster,
  Sphere,
  Spherical,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import { FlyControls } from './FlyControls';

CameraControls.install({
  THREE: { Vector2, Vector3, Vector4, Quaternion, Matrix4, Spherical, Box3, Sphere, Raycaster },
});
const { ACTION } = CameraControls;

/** Distance (m) of the point that is orbited when nothing is seen there, not even the ground, and the longest one. */
const DEFAULT_DISTANCE = 15;
const FARTHEST_TARGET = 60;

/** What keys do while the canvas has the focus: angles (rad), or with Shift parts of the distance. */
const nudges: Readonly<
  Record<string, { azimuth?: number; polar?: number; right?: number; up?: number; closer?: number }>
> = {
  ArrowLeft: { azimuth: -0.12 },
  ArrowRight: { azimuth: 0.12 },
  ArrowUp: { polar: -0.08 },
  ArrowDown: { polar: 0.08 },
  'Shift+ArrowLeft': { right: -0.06 },
  'Shift+ArrowRight': { right: 0.06 },
  'Shift+ArrowUp': { up: 0.06 },
  'Shift+ArrowDown': { up: -0.06 },
  '+': { closer: 0.15 },
  '-': { closer: -0.15 },
};

/** Ratio of width to height from which a picture is wide. */
const WIDE = 16 / 9;

const eye = new Vector3();
const front = new Vector3();

/**
 * The camera that the editor looks with. Left button: orbit; middle, or Shift and left: pan; wheel: nearer and farther,
 * towards the pointer; right button: look around and fly. Fingers: one orbits, two pan and zoom.
 */
export class EditorCamera {
  readonly camera = new PerspectiveCamera(50, 1, 0.05, 1000);
  readonly fly: FlyControls;

  private readonly controls: CameraControls;
  /** Vertical field of view of a wide picture (degrees). */
  private fov = 50;

  constructor(private readonly canvas: HTMLCanvasElement) {
    const controls = new CameraControls(this.camera, canvas);
    controls.mouseButtons = {
      left: ACTION.ROTATE,
      middle: ACTION.TRUCK,
      right: ACTION.NONE,
      wheel: ACTION.DOLLY,
    };
    controls.touches = { one: ACTION.TOUCH_ROTATE, two: ACTION.TOUCH_DOLLY_TRUCK, three: ACTION.NONE };
    controls.dollyToCursor = true;
    controls.minDistance = 0.05;
    controls.maxDistance = 2000;
    const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
    controls.smoothTime = calm ? 0 : 0.12;
    controls.draggingSmoothTime = calm ? 0 : 0.04;
    this.controls = controls;
    this.fly = new FlyControls(canvas, controls, () => this.controls.enabled);
    canvas.addEventListener('pointerdown', this.chooseAction, true);
    canvas.addEventListener('keydown', this.keyDown);
  }

  /** False while something else, such as the gizmo, has the pointer. */
  get enabled(): boolean {
    return this.controls.enabled;
  }

  set enabled(enabled: boolean) {
    this.controls.enabled = enabled;
  }

  /** Whether one finger orbits; two pan and zoom in any case. */
  set oneFinger(orbits: boolean) {
    this.controls.touches.one = orbits ? ACTION.TOUCH_ROTATE : ACTION.NONE;
  }

  /** The point that is orbited, in the world: a copy. */
  get target(): Vector3 {
    return this.controls.getTarget(new Vector3(), false);
  }

  /** Moves on towards where the camera is to be. @returns whether the picture changes */
  update(deltaSeconds: number): boolean {
    const flew = this.fly.update(deltaSeconds);
    return this.controls.update(deltaSeconds) || flew;
  }

  /** Tells the size of the picture, in any unit. A narrow picture shows as much from left to right as a wide one. */
  resize(width: number, height: number): void {
    const { camera } = this;
    camera.aspect = width / height;
    const narrow = Math.max(1, WIDE / camera.aspect);
    camera.fov = 2 * Math.atan(Math.tan((this.fov * MathUtils.DEG2RAD) / 2) * narrow) * MathUtils.RAD2DEG;
    camera.updateProjectionMatrix();
  }

  /** Looks at a box of the world, from the present side. @param animate - whether to glide there */
  focus(box: Box3, animate = true): void {
    const sphere = box.getBoundingSphere(new Sphere());
    sphere.radius = Math.max(sphere.radius * 1.15, 0.5);
    const glide = animate && this.controls.smoothTime > 0;
    void this.controls.fitToSphere(sphere, glide);
    if (!glide) this.controls.update(0);
  }

  /**
   * Looks from where a camera of the scene is.
   * @param distanceTo - distance (m) of what that camera sees in its middle; null when there is nothing
   */
  matchCamera({ three }: CameraComponent, distanceTo: (camera: Camera) => number | null): void {
    if (three instanceof PerspectiveCamera) this.fov = three.fov;
    this.camera.near = Math.min(0.05, three.near);
    this.camera.far = Math.max(1000, three.far);
    this.resize(this.camera.aspect, 1);
    three.updateWorldMatrix(true, false);
    eye.setFromMatrixPosition(three.matrixWorld);
    front.setFromMatrixColumn(three.matrixWorld, 2).normalize().negate();
    const toGround = front.y < 0 ? -eye.y / front.y : DEFAULT_DISTANCE;
    const distance = Math.min(distanceTo(three) ?? toGround, FARTHEST_TARGET);
    front.multiplyScalar(distance).add(eye);
    void this.controls.setLookAt(eye.x, eye.y, eye.z, front.x, front.y, front.z, false);
    this.controls.update(0);
  }

  /**
   * Looks at the same point from another side.
   * @param direction - from the point to the camera, in the world
   */
  lookFrom(direction: Vector3): void {
    const { controls } = this;
    const target = this.target;
    const spherical = new Spherical().setFromVector3(direction);
    void controls.setTarget(target.x, target.y, target.z, false);
    // the shorter way round
    const turns = Math.round((controls.azimuthAngle - spherical.theta) / (2 * Math.PI));
    void controls.rotateTo(spherical.theta + turns * 2 * Math.PI, spherical.phi, controls.smoothTime > 0);
    if (controls.smoothTime === 0) controls.update(0);
  }

  /** From now on hears of the pointer after all that listens to the canvas now. */
  listenLast(): void {
    this.controls.disconnect();
    this.controls.connect(this.canvas);
  }

  dispose(): void {
    this.canvas.removeEventListener('pointerdown', this.chooseAction, true);
    this.canvas.removeEventListener('keydown', this.keyDown);
    this.fly.dispose();
    this.controls.dispose();
  }

  private readonly chooseAction = (event: PointerEvent): void => {
    this.controls.mouseButtons.left = event.shiftKey ? ACTION.TRUCK : ACTION.ROTATE;
  };

  private readonly keyDown = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.enabled) return;
    const {
      azimuth = 0,
      polar = 0,
      right = 0,
      up = 0,
      closer = 0,
    } = nudges[event.shiftKey && event.key.length > 1 ? `Shift+${event.key}` : event.key] ?? {};
    const { controls } = this;
    if (azimuth !== 0 || polar !== 0) void controls.rotate(azimuth, polar, true);
    else if (right !== 0 || up !== 0) void controls.truck(right * controls.distance, -up * controls.distance, true);
    else if (closer !== 0) void controls.dolly(closer * controls.distance, true);
    else return;
    event.preventDefault();
  };
}
