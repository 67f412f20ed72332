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

/** Orbit distance (m) when nothing is hit, not even the ground; and the longest one. */
const DEFAULT_DISTANCE = 15;
const FARTHEST_TARGET = 60;

/** Movement for each key while the canvas has focus: angles (rad); with Shift, + and - shares of the orbit distance. */
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

/** Aspect ratio from which a view counts as wide. */
const WIDE = 16 / 9;

/** Rotation (rad) below which an axis-aligned view stays one. */
const SIDE_REACH = 1e-3;

const eye = new Vector3();
const front = new Vector3();
const angles = new Spherical();
const calm = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches;

/**
 * The editor's own camera. Left button orbits; middle, or Shift and left, pans; the wheel zooms towards the pointer;
 * the right button looks around and flies. One finger orbits, two pan and zoom. The controls move a perspective camera;
 * its orthographic twin renders views without perspective, matching it at the distance of the target.
 */
export class EditorCamera {
  readonly perspective = new PerspectiveCamera(50, 1, 0.05, 1000);
  readonly fly: FlyControls;

  private readonly controls: CameraControls;
  private readonly flat = new OrthographicTwin();
  private isFlat = false;
  /** Angles of an orthographic axis-aligned view, kept until the user orbits; null for none. */
  private side: Spherical | null = null;
  /** Vertical field of view for a wide aspect ratio (degrees). */
  private fov = 50;
  /** Whether the field of view is widened for narrow viewports, to show as much horizontally as a wide one. */
  private widens = true;
  private isWanted = true;
  private isAllowed = true;
  private isActive = false;

  /** @param hasKeys - asked at each key press whether the controls may use it */
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

  get camera(): PerspectiveCamera | OrthographicCamera {
    return this.isFlat ? this.flat.camera : this.perspective;
  }

  /** Camera for raycasting: same view as `camera`, with rays that start far enough back to hit everything visible. */
  get rayCamera(): PerspectiveCamera | OrthographicCamera {
    return this.isFlat ? this.flat.rays : this.perspective;
  }

  get orthographic(): boolean {
    return this.isFlat;
  }

  set orthographic(orthographic: boolean) {
    this.isFlat = orthographic;
    this.side = null;
    this.follow();
  }

  /** Height of the view at the distance of the target (m). */
  get height(): number {
    return 2 * this.controls.distance * Math.tan((this.perspective.fov * MathUtils.DEG2RAD) / 2);
  }

  /** The pose that the camera has, or is gliding to. */
  get pose(): ViewPose {
    return {
      position: this.controls.getPosition(new Vector3()).toArray(),
      target: this.controls.getTarget(new Vector3()).toArray(),
      fov: this.fov * MathUtils.DEG2RAD,
      orthographic: this.isFlat,
    };
  }

  /** False while something else, such as the gizmo, uses the pointer. */
  get enabled(): boolean {
    return this.controls.enabled;
  }

  set enabled(enabled: boolean) {
    this.isWanted = enabled;
    this.enable();
  }

  /** False while there is nothing that the controls may move, such as a camera that cannot be moved. */
  set allowed(allowed: boolean) {
    this.isAllowed = allowed;
    this.enable();
  }

  /** Whether pointer and keys on the canvas are meant for this view's camera. False at first. */
  set active(active: boolean) {
    this.isActive = active;
    this.enable();
  }

  /** Distance from the eye to the target (m). */
  get distance(): number {
    return this.controls.distance;
  }

  /** Whether movements are damped; never when the user prefers reduced motion. */
  set glides(glides: boolean) {
    const isSoft = glides && !calm();
    this.controls.smoothTime = isSoft ? 0.12 : 0;
    this.controls.draggingSmoothTime = isSoft ? 0.04 : 0;
  }

  /** Whether one finger orbits; two always pan and zoom. */
  set oneFinger(orbits: boolean) {
    this.controls.touches.one = orbits ? ACTION.TOUCH_ROTATE : ACTION.NONE;
  }

  /** A copy of the orbit target (world). */
  get target(): Vector3 {
    return this.controls.getTarget(new Vector3(), false);
  }

  /** Advances the camera's movement. @returns whether the view changed */
  update(deltaSeconds: number): boolean {
    const flew = this.fly.update(deltaSeconds);
    const moved = this.controls.update(deltaSeconds) || flew;
    if (!moved) return false;
    if (this.side && this.hasTurnedFrom(this.side)) this.orthographic = false;
    this.follow();
    return true;
  }

  /** Sets the aspect ratio from a size in any unit. A narrow viewport shows as much horizontally as a wide one. */
  resize(width: number, height: number): void {
    const { perspective } = this;
    perspective.aspect = width / height;
    const narrow = this.widens ? Math.max(1, WIDE / perspective.aspect) : 1;
    perspective.fov = 2 * Math.atan(Math.tan((this.fov * MathUtils.DEG2RAD) / 2) * narrow) * MathUtils.RAD2DEG;
    perspective.updateProjectionMatrix();
    this.follow();
  }

  /** Frames a box (world) from the current direction. @param animate - whether to glide there */
  focus(box: Box3, animate = true): void {
    const sphere = box.getBoundingSphere(new Sphere());
    sphere.radius = Math.max(sphere.radius * 1.15, 0.5);
    const glide = animate && this.controls.smoothTime > 0;
    void this.controls.fitToSphere(sphere, glide);
    if (!glide) this.settle();
  }

  /** Sets the pose. @param animate - whether to glide there */
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
   * Takes over the pose of a scene's camera, with its field of view or size.
   * @param distanceTo - distance (m) of what that camera sees at its centre; null when there is nothing
   * @param exact - whether a narrow viewport shows no more than that camera does
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
   * Views the target from another direction.
   * @param direction - from the target to the camera, in the world
   * @param flat - orthographic; a perspective view returns when the user orbits
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

  /** Orbits the target. @param azimuth - to the right (rad) @param polar - downwards (rad) */
  orbit(azimuth: number, polar: number): void {
    void this.controls.rotate(azimuth, polar, true);
  }

  /** Registers the pointer listeners again, after those that the canvas has now. */
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

  /** Rotates to angles by the shorter way round. */
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
