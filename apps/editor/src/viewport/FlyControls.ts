import type CameraControls from 'camera-controls';
import { type PerspectiveCamera, Vector3 } from 'three';

/** Rotation per pixel of pointer movement (rad). */
const TURN = 0.0035;

/** Speed in orthographic views: share of the orbit distance per second, for each m/s of `speed`. */
const FLAT_PART = 0.08;

/** Largest pitch above or below the horizon (rad). */
const PITCH_LIMIT = Math.PI / 2 - 0.01;

/** Direction of each key: right, up, forward. */
const directions: Readonly<Record<string, readonly [number, number, number]>> = {
  KeyW: [0, 0, 1],
  KeyS: [0, 0, -1],
  KeyA: [-1, 0, 0],
  KeyD: [1, 0, 0],
  KeyQ: [0, -1, 0],
  KeyE: [0, 1, 0],
  ArrowUp: [0, 0, 1],
  ArrowDown: [0, 0, -1],
  ArrowLeft: [-1, 0, 0],
  ArrowRight: [1, 0, 0],
};

const position = new Vector3();
const direction = new Vector3();
const right = new Vector3();
const move = new Vector3();
const UP = new Vector3(0, 1, 0);

/**
 * Looks around and flies while the right button is held: pointer movement rotates, W A S D Q E move, Shift is faster,
 * the wheel changes the speed.
 */
export class FlyControls {
  /** Speed of flight (m/s). */
  speed = 6;

  /** Whether keys or the wheel were used since the right button was last pressed. */
  flew = false;
  private readonly listening = new AbortController();
  private pointer: number | null = null;
  private readonly held = new Set<string>();
  private fast = false;
  private yaw = 0;
  private pitch = 0;

  /**
   * @param canvas - receives the button presses
   * @param controls - controls of the camera to move; disabled during flight
   * @param isEnabled - called when the button is pressed: whether flying is allowed
   * @param isFlat - whether the view is orthographic: pointer movement then orbits, and forward zooms in
   */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly controls: CameraControls,
    private readonly isEnabled: () => boolean,
    private readonly isFlat: () => boolean,
  ) {
    const { signal } = this.listening;
    canvas.addEventListener('pointerdown', this.pointerDown, { signal });
    canvas.addEventListener('pointermove', this.pointerMove, { signal });
    canvas.addEventListener('pointerup', this.pointerUp, { signal });
    canvas.addEventListener('lostpointercapture', this.pointerUp, { signal });
    canvas.addEventListener('wheel', this.wheel, { capture: true, passive: false, signal });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
    window.addEventListener('keydown', this.keyDown, { capture: true, signal });
    window.addEventListener('keyup', this.keyUp, { capture: true, signal });
    window.addEventListener('blur', this.end, { signal });
  }

  get isFlying(): boolean {
    return this.pointer !== null;
  }

  /** Moves the camera. @returns whether it moved */
  update(deltaSeconds: number): boolean {
    if (!this.isFlying) return false;
    const turned = this.yaw !== 0 || this.pitch !== 0;
    if (!turned && this.held.size === 0) return false;
    if (this.isFlat()) return this.updateFlat(deltaSeconds);
    const { controls } = this;
    controls.getPosition(position, false);
    controls.getTarget(direction, false).sub(position);
    const distance = Math.max(direction.length(), 0.01);
    direction.divideScalar(distance);
    this.turn();
    right.crossVectors(direction, UP).normalize();
    move.set(0, 0, 0);
    for (const code of this.held) {
      const [x, y, z] = directions[code];
      move.addScaledVector(right, x).addScaledVector(UP, y).addScaledVector(direction, z);
    }
    if (move.lengthSq() > 0)
      position.addScaledVector(move.normalize(), this.speed * (this.fast ? 4 : 1) * deltaSeconds);
    direction.multiplyScalar(distance).add(position);
    void controls.setLookAt(position.x, position.y, position.z, direction.x, direction.y, direction.z, false);
    return true;
  }

  dispose(): void {
    this.listening.abort();
  }

  /** Moves in an orthographic view: the speed is proportional to the height of the view, and forward zooms in. */
  private updateFlat(deltaSeconds: number): boolean {
    const { controls } = this;
    if (this.yaw !== 0 || this.pitch !== 0) void controls.rotate(-this.yaw * TURN, -this.pitch * TURN, false);
    this.yaw = 0;
    this.pitch = 0;
    move.set(0, 0, 0);
    for (const code of this.held) {
      const [x, y, z] = directions[code];
      move.x += x;
      move.y += y;
      move.z += z;
    }
    const part = FLAT_PART * this.speed * (this.fast ? 4 : 1) * deltaSeconds;
    if (move.x !== 0 || move.y !== 0)
      void controls.truck(move.x * part * controls.distance, -move.y * part * controls.distance, false);
    if (move.z !== 0) void controls.dollyTo(controls.distance * Math.exp(-move.z * part), false);
    return true;
  }

  /** Rotates `direction` by the pointer's movement. */
  private turn(): void {
    const camera = this.controls.camera as PerspectiveCamera;
    const scale = TURN * Math.min(1, camera.fov / 60);
    const pitch = Math.asin(Math.min(1, Math.max(-1, direction.y)));
    const next = Math.min(PITCH_LIMIT, Math.max(-PITCH_LIMIT, pitch - this.pitch * scale));
    const yaw = Math.atan2(direction.x, direction.z) - this.yaw * scale;
    direction.set(Math.sin(yaw) * Math.cos(next), Math.sin(next), Math.cos(yaw) * Math.cos(next));
    this.yaw = 0;
    this.pitch = 0;
  }

  private readonly pointerDown = (event: PointerEvent): void => {
    if (event.button !== 2 || this.isFlying) return;
    this.flew = false;
    if (!this.isEnabled()) return;
    this.pointer = event.pointerId;
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus({ preventScroll: true });
  };

  private readonly pointerMove = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer) return;
    this.yaw += event.movementX;
    this.pitch += event.movementY;
  };

  private readonly pointerUp = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer || (event.buttons & 2) !== 0) return;
    this.end();
  };

  private readonly wheel = (event: WheelEvent): void => {
    if (!this.isFlying) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.flew = true;
    this.speed = Math.min(200, Math.max(0.2, this.speed * (event.deltaY < 0 ? 1.2 : 1 / 1.2)));
  };

  private readonly keyDown = (event: KeyboardEvent): void => {
    this.fast = event.shiftKey;
    if (!this.isFlying || !(event.code in directions)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.flew = true;
    this.held.add(event.code);
  };

  private readonly keyUp = (event: KeyboardEvent): void => {
    this.fast = event.shiftKey;
    this.held.delete(event.code);
    // macOS sends no keyup events while Command is held
    if (event.key === 'Meta') this.held.clear();
  };

  private readonly end = (): void => {
    this.pointer = null;
    this.held.clear();
    this.yaw = 0;
    this.pitch = 0;
  };
}
