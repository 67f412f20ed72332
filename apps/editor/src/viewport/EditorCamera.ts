import type { CameraComponent } from '@farol/engine';
import CameraControls from 'camera-controls';
import {
  Box3,
  type Camera,
  MathUtils,
  Matrix4,
  type OrthographicCamera,
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
import { OrthographicTwin } from './OrthographicTwin';
import type { ViewPose } from './ViewPose';

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

/** A turn by less than this (rad) leaves a picture as seen from a side. */
const SIDE_REACH = 1e-3;

const eye = new Vector3();
const front = new Vector3();
const angles = new Spherical();
const calm = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches;

/**
 * The camera that the editor looks with. Left button: orbit; middle, or Shift and left: pan; wheel: nearer and farther,
 * towards the pointer; right button: look around and fly. Fingers: one orbits, two pan and zoom. The controls move a
 * perspective camera; without perspective its twin draws, so that both show the same at the distance of the target.
 */
export class EditorCamera {
  readonly perspective = new PerspectiveCamera(50, 1, 0.05, 1000);
  readonly fly: FlyControls;

  private readonly controls: CameraControls;
  private readonly flat = new OrthographicTwin();
  private isFlat = false;
  /** The angles of a side that is looked from without perspective until the picture is turned; null for none. */
  private side: Spherical | null = null;
  /** Vertical field of view of a wide picture (degrees). */
  private fov = 50;
  /** Whether a narrow picture shows as much from left to right as a wide one. */
  private widens = true;
  private isWanted = true;
  private isAllowed = true;
  private isActive = false;

  /** @param hasKeys - asked at each key whether it is the controls' */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly hasKeys: () => boolean = () => true,
  ) {
    const controls = new CameraControls(this.perspective, canvas);
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
    this.controls = controls;
    controls.enabled = false;
    this.glides = true;
    this.fly = new FlyControls(
      canvas,
      controls,
      () => this.controls.enabled,
      () => this.isFlat && this.side === null,
    );
    canvas.addEventListener('pointerdown', this.chooseAction, true);
    canvas.addEventListener('keydown', this.keyDown);
  }

  /** What the picture is drawn with. */
  get camera(): PerspectiveCamera | OrthographicCamera {
    return this.isFlat ? this.flat.camera : this.perspective;
  }

  /** Sees the same as `camera`; rays that begin at its eye meet all that is seen. */
  get rayCamera(): PerspectiveCamera | OrthographicCamera {
    return this.isFlat ? this.flat.rays : this.perspective;
  }

  /** Whether the picture is without perspective. */
  get orthographic(): boolean {
    return this.isFlat;
  }

  set orthographic(orthographic: boolean) {
    this.isFlat = orthographic;
    this.side = null;
    this.follow();
  }

  /** Height of what is seen at the distance of the target (m). */
  get height(): number {
    return 2 * this.controls.distance * Math.tan((this.perspective.fov * MathUtils.DEG2RAD) / 2);
  }

  /** Where it looks from and to, once it is at rest. */
  get pose(): ViewPose {
    return {
      position: this.controls.getPosition(new Vector3()).toArray(),
      target: this.controls.getTarget(new Vector3()).toArray(),
      fov: this.fov * MathUtils.DEG2RAD,
      orthographic: this.isFlat,
    };
  }

  /** False while something else, such as the gizmo, has the pointer. */
  get enabled(): boolean {
    return this.controls.enabled;
  }

  set enabled(enabled: boolean) {
    this.isWanted = enabled;
    this.enable();
  }

  /** False while there is nothing that the controls may move. */
  set allowed(allowed: boolean) {
    this.isAllowed = allowed;
    this.enable();
  }

  /** Whether pointer and keys are for this camera among those of the canvas. False at first. */
  set active(active: boolean) {
    this.isActive = active;
    this.enable();
  }

  /** From the eye to the target (m). */
  get distance(): number {
    return this.controls.distance;
  }

  /** Whether it comes to rest softly; never for those who prefer reduced motion. */
  set glides(glides: boolean) {
    const isSoft = glides && !calm();
    this.controls.smoothTime = isSoft ? 0.12 : 0;
    this.controls.draggingSmoothTime = isSoft ? 0.04 : 0;
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
    const moved = this.controls.update(deltaSeconds) || flew;
    if (!moved) return false;
    if (this.side && this.hasTurnedFrom(this.side)) this.orthographic = false;
    this.follow();
    return true;
  }

  /** Tells the size of the picture, in any unit. A narrow picture shows as much from left to right as a wide one. */
  resize(width: number, height: number): void {
    const { perspective } = this;
    perspective.aspect = width / height;
    const narrow = this.widens ? Math.max(1, WIDE / perspective.aspect) : 1;
    perspective.fov = 2 * Math.atan(Math.tan((this.fov * MathUtils.DEG2RAD) / 2) * narrow) * MathUtils.RAD2DEG;
    perspective.updateProjectionMatrix();
    this.follow();
  }

  /** Looks at a box of the world, from the present side. @param animate - whether to glide there */
  focus(box: Box3, animate = true): void {
    const sphere = box.getBoundingSphere(new Sphere());
    sphere.radius = Math.max(sphere.radius * 1.15, 0.5);
    const glide = animate && this.controls.smoothTime > 0;
    void this.controls.fitToSphere(sphere, glide);
    if (!glide) this.settle();
  }

  /** Looks from elsewhere. @param animate - whether to glide there */
  show(pose: ViewPose, animate = true): void {
    const glide = animate && this.controls.smoothTime > 0;
    this.fov = pose.fov * MathUtils.RAD2DEG;
    this.widens = true;
    this.orthographic = pose.orthographic;
    this.resize(this.perspective.aspect, 1);
    void this.controls.setLookAt(...pose.position, ...pose.target, glide);
    if (glide) this.turnTo(this.controls.getSpherical(new Spherical()));
    else this.settle();
  }

  /**
   * Looks from where a camera of the scene is, with its field of view or size.
   * @param distanceTo - distance (m) of what that camera sees in its middle; null when there is nothing
   * @param exact - whether a narrow picture shows no more than that camera does
   */
  matchCamera({ three }: CameraComponent, distanceTo: (camera: Camera) => number | null, exact = false): void {
    if (three instanceof PerspectiveCamera) this.fov = three.fov;
    this.widens = !exact;
    this.orthographic = !(three instanceof PerspectiveCamera);
    this.perspective.near = Math.min(0.05, three.near);
    this.perspective.far = Math.max(1000, three.far);
    this.resize(this.perspective.aspect, 1);
    three.updateWorldMatrix(true, false);
    eye.setFromMatrixPosition(three.matrixWorld);
    front.setFromMatrixColumn(three.matrixWorld, 2).normalize().negate();
    let distance: number;
    if (three instanceof PerspectiveCamera) {
      const toGround = front.y < 0 ? -eye.y / front.y : DEFAULT_DISTANCE;
      distance = Math.min(distanceTo(three) ?? toGround, FARTHEST_TARGET);
    } else distance = three.top / three.zoom / Math.tan((this.fov * MathUtils.DEG2RAD) / 2);
    front.multiplyScalar(Math.max(distance, this.controls.minDistance)).add(eye);
    void this.controls.setLookAt(eye.x, eye.y, eye.z, front.x, front.y, front.z, false);
    this.settle();
  }

  /**
   * Looks at the same point from another side.
   * @param direction - from the point to the camera, in the world
   * @param flat - without perspective; where there was some, it comes back once the picture is turned
   */
  lookFrom(direction: Vector3, flat = false): void {
    const { controls } = this;
    const target = this.target;
    const returns = this.side !== null || !this.isFlat;
    void controls.setTarget(target.x, target.y, target.z, false);
    this.turnTo(new Spherical().setFromVector3(direction));
    if (flat) {
      this.orthographic = true;
      this.side = returns ? controls.getSpherical(new Spherical()) : null;
    }
    if (controls.smoothTime === 0) this.settle();
  }

  /** Turns round the target. @param azimuth - to the right (rad) @param polar - downwards (rad) */
  orbit(azimuth: number, polar: number): void {
    void this.controls.rotate(azimuth, polar, true);
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

  private enable(): void {
    const enabled = this.isWanted && this.isAllowed && this.isActive;
    if (this.controls.enabled !== enabled) this.controls.enabled = enabled;
  }

  private follow(): void {
    if (this.isFlat) this.flat.follow(this.perspective, this.controls.distance);
  }

  /** Turns to angles by the shorter way round. */
  private turnTo({ theta, phi }: Spherical): void {
    const { controls } = this;
    const turns = Math.round((controls.azimuthAngle - theta) / (2 * Math.PI));
    void controls.rotateTo(theta + turns * 2 * Math.PI, phi, controls.smoothTime > 0);
  }

  private settle(): void {
    this.controls.update(0);
    this.follow();
  }

  private hasTurnedFrom(side: Spherical): boolean {
    this.controls.getSpherical(angles);
    return Math.abs(angles.theta - side.theta) > SIDE_REACH || Math.abs(angles.phi - side.phi) > SIDE_REACH;
  }

  private readonly chooseAction = (event: PointerEvent): void => {
    this.controls.mouseButtons.left = event.shiftKey ? ACTION.TRUCK : ACTION.ROTATE;
  };

  private readonly keyDown = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.enabled || !this.hasKeys()) return;
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
