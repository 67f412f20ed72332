import type { CameraComponent } from '@farol/engine';
import type CameraControls from 'camera-controls';
import {
  type Box3,
  type Camera,
  MathUtils,
  type OrthographicCamera,
  PerspectiveCamera,
  Sphere,
  Spherical,
  Vector3,
} from 'three';
import type { FlyControls } from './FlyControls';
import { OrthographicTwin } from './OrthographicTwin';
import type { PointerControls } from './PointerControls';
import type { ViewPose } from './ViewPose';

/** Smallest and largest distance from the eye to the orbit target (m). */
export const NEAREST = 0.05;
export const FARTHEST = 2000;

/** Orbit distance (m) when the view hits nothing, not even the ground; below, the largest distance taken from a hit. */
const DEFAULT_DISTANCE = 15;
const FARTHEST_TARGET = 60;

/** Aspect ratio from which a view counts as wide. */
const WIDE = 16 / 9;

/** Rotation (rad) below which an axis-aligned view stays axis-aligned. */
const SIDE_REACH = 1e-3;

const eye = new Vector3();
const front = new Vector3();
const offset = new Vector3();
const calm = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches;

/**
 * The editor's own camera. PointerControls move a perspective camera; an orthographic camera of the same view, which
 * matches it at the distance of the target, renders without perspective. Without controls the camera does not glide.
 */
export class EditorCamera {
  readonly perspective = new PerspectiveCamera(50, 1, 0.05, 1000);

  private controls: PointerControls | null = null;
  /** Eye of the perspective camera (world) as long as there are no controls; `aim` is its orbit target. */
  private readonly eye = new Vector3(0, 0, DEFAULT_DISTANCE);
  private readonly aim = new Vector3();
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
  private isSoft = !calm();

  /** @param hasKeys - called at each key press: whether the controls may use the key */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly hasKeys: () => boolean = () => true,
  ) {}

  /** Creates the controls by which pointer, wheel and keys move the camera; further calls do nothing. */
  control(Controls: typeof PointerControls): void {
    if (this.controls) return;
    this.controls = new Controls(this.perspective, this.canvas, {
      isEnabled: () => this.enabled,
      hasKeys: this.hasKeys,
      isFlat: () => this.isFlat && this.side === null,
    });
    this.enable();
    this.smooth();
    this.place(this.eye, this.aim, false);
  }

  /** Flight with the right button; null until there are controls. */
  get fly(): FlyControls | null {
    return this.controls?.fly ?? null;
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

  /** Height of the visible area at the distance of the target (m). */
  get height(): number {
    return 2 * this.distance * Math.tan((this.perspective.fov * MathUtils.DEG2RAD) / 2);
  }

  /** The pose that the camera has, or is gliding to. */
  get pose(): ViewPose {
    return {
      position: (this.orbiter?.getPosition(new Vector3()) ?? this.eye).toArray(),
      target: (this.orbiter?.getTarget(new Vector3()) ?? this.aim).toArray(),
      fov: this.fov * MathUtils.DEG2RAD,
      orthographic: this.isFlat,
    };
  }

  /** Whether the controls may be used; false while something else, such as the gizmo, uses the pointer. */
  get enabled(): boolean {
    return this.isWanted && this.isAllowed && this.isActive;
  }

  set enabled(enabled: boolean) {
    this.isWanted = enabled;
    this.enable();
  }

  /** Whether the view may change; false when a camera is shown that cannot be moved. */
  set allowed(allowed: boolean) {
    this.isAllowed = allowed;
    this.enable();
  }

  /** Whether pointer and keys on the canvas control this view's camera. False at first. */
  set active(active: boolean) {
    this.isActive = active;
    this.enable();
  }

  /** Distance from the eye to the target (m). */
  get distance(): number {
    return this.orbiter?.distance ?? this.eye.distanceTo(this.aim);
  }

  /** Whether movements are damped; never when the user prefers reduced motion, nor without controls. */
  get glides(): boolean {
    return this.controls !== null && this.isSoft;
  }

  set glides(glides: boolean) {
    this.isSoft = glides && !calm();
    this.smooth();
  }

  /** Whether one finger orbits; two always pan and zoom. */
  set oneFinger(orbits: boolean) {
    if (this.controls) this.controls.oneFinger = orbits;
  }

  /** A copy of the orbit target (world). */
  get target(): Vector3 {
    return this.orbiter?.getTarget(new Vector3(), false) ?? this.aim.clone();
  }

  /** Advances the camera's movement. @returns whether the view changed */
  update(deltaSeconds: number): boolean {
    if (!this.controls) return false;
    const flew = this.controls.fly.update(deltaSeconds);
    const moved = this.controls.orbit.update(deltaSeconds) || flew;
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
    const radius = Math.max(sphere.radius * 1.15, 0.5);
    const { fov, aspect } = this.perspective;
    const narrower = Math.atan(Math.tan((fov * MathUtils.DEG2RAD) / 2) * Math.min(1, aspect));
    const { phi, theta } = this.angles();
    const distance = MathUtils.clamp(radius / Math.sin(narrower), NEAREST, FARTHEST);
    eye.setFromSphericalCoords(distance, phi, theta).add(sphere.center);
    this.place(eye, sphere.center, animate);
  }

  /** Sets the pose. @param animate - whether to glide there */
  show(pose: ViewPose, animate = true): void {
    this.fov = pose.fov * MathUtils.RAD2DEG;
    this.widens = true;
    this.orthographic = pose.orthographic;
    this.resize(this.perspective.aspect, 1);
    this.place(eye.fromArray(pose.position), front.fromArray(pose.target), animate);
    if (animate && this.glides) this.turnTo(this.angles());
  }

  /**
   * Takes over the pose of a scene's camera, with its field of view or size.
   * @param distanceTo - distance (m) of what that camera sees at its centre; null when there is nothing
   * @param exact - whether a narrow viewport shows no more than that camera
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
    this.place(eye, front.multiplyScalar(Math.max(distance, NEAREST)).add(eye), false);
  }

  /**
   * Views the target from another direction.
   * @param direction - from the target to the camera, in the world
   * @param flat - whether the view is orthographic until the user orbits
   */
  lookFrom(direction: Vector3, flat = false): void {
    const { x, y, z } = this.target;
    const returns = this.side !== null || !this.isFlat;
    void this.orbiter?.setTarget(x, y, z, false);
    this.turnTo(new Spherical().setFromVector3(direction));
    if (flat) {
      this.orthographic = true;
      this.side = returns ? this.angles() : null;
    }
    if (!this.glides) this.settle();
  }

  /** Moves the camera around the target. @param azimuth - to the right (rad) @param polar - downwards (rad) */
  orbit(azimuth: number, polar: number): void {
    if (this.orbiter) return void this.orbiter.rotate(azimuth, polar, true);
    const { phi, theta } = this.angles();
    this.turnTo(new Spherical(1, phi + polar, theta + azimuth));
    this.settle();
  }

  /** Registers the pointer listeners again, so that they run after the canvas's other listeners. */
  listenLast(): void {
    this.controls?.listenLast();
  }

  dispose(): void {
    this.controls?.dispose();
  }

  private get orbiter(): CameraControls | undefined {
    return this.controls?.orbit;
  }

  private enable(): void {
    const { orbiter, enabled } = this;
    if (orbiter && orbiter.enabled !== enabled) orbiter.enabled = enabled;
  }

  private smooth(): void {
    const { orbiter, isSoft } = this;
    if (!orbiter) return;
    orbiter.smoothTime = isSoft ? 0.12 : 0;
    orbiter.draggingSmoothTime = isSoft ? 0.04 : 0;
  }

  /** Places the camera at a point, looking at a target. @param animate - whether to glide there if it can */
  private place(position: Vector3, target: Vector3, animate: boolean): void {
    const glide = animate && this.glides;
    void this.orbiter?.setLookAt(...position.toArray(), ...target.toArray(), glide);
    this.eye.copy(position);
    this.aim.copy(target);
    if (!glide) this.settle();
  }

  /** Angles and distance of the camera from the target, at the end of a glide. */
  private angles(): Spherical {
    const angles = new Spherical();
    return (
      this.orbiter?.getSpherical(angles) ?? angles.setFromVector3(offset.subVectors(this.eye, this.aim)).makeSafe()
    );
  }

  private follow(): void {
    if (this.isFlat) this.flat.follow(this.perspective, this.distance);
  }

  /** Rotates the camera around the target to these angles, by the shorter way round. */
  private turnTo({ theta, phi }: Spherical): void {
    const { orbiter } = this;
    if (!orbiter) return void this.eye.setFromSphericalCoords(this.distance, phi, theta).add(this.aim);
    const turns = Math.round((orbiter.azimuthAngle - theta) / (2 * Math.PI));
    void orbiter.rotateTo(theta + turns * 2 * Math.PI, phi, this.glides);
  }

  private settle(): void {
    const { orbiter, perspective, aim } = this;
    if (orbiter) orbiter.update(0);
    else {
      perspective.position.setFromSpherical(this.angles()).add(aim);
      perspective.lookAt(aim);
      perspective.updateMatrixWorld();
    }
    this.follow();
  }

  private hasTurnedFrom(side: Spherical): boolean {
    const { theta, phi } = this.angles();
    return Math.abs(theta - side.theta) > SIDE_REACH || Math.abs(phi - side.phi) > SIDE_REACH;
  }
}
