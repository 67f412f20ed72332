import CameraControls from 'camera-controls';
import {
  Box3,
  Matrix4,
  type PerspectiveCamera,
  Quaternion,
  Raycaster,
  Sphere,
  Spherical,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import { FARTHEST, NEAREST } from './EditorCamera';
import { FlyControls } from './FlyControls';

CameraControls.install({
  THREE: { Vector2, Vector3, Vector4, Quaternion, Matrix4, Spherical, Box3, Sphere, Raycaster },
});
const { ACTION } = CameraControls;

/** Movement per key press while the canvas has focus: angles (rad), or shares of the distance to the target. */
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

/** State that PointerControls read from their camera. */
export interface ControlsHost {
  /** Whether pointer and keys may move the camera. */
  isEnabled(): boolean;
  /** Called at each key press: whether the controls may use the key. */
  hasKeys(): boolean;
  /** Whether flying moves in the plane of the view, as in orthographic views. */
  isFlat(): boolean;
}

/**
 * Pointer, wheel and keys of one EditorCamera. The left button orbits; the middle one, or Shift and the left, pans; the
 * wheel zooms towards the pointer; the right button looks around and flies. One finger orbits, two pan and zoom. The
 * code is fetched with the panel that shows the canvas.
 */
export class PointerControls {
  readonly orbit: CameraControls;
  readonly fly: FlyControls;

  constructor(
    camera: PerspectiveCamera,
    private readonly canvas: HTMLCanvasElement,
    private readonly host: ControlsHost,
  ) {
    const orbit = new CameraControls(camera, canvas);
    orbit.mouseButtons = { left: ACTION.ROTATE, middle: ACTION.TRUCK, right: ACTION.NONE, wheel: ACTION.DOLLY };
    orbit.touches = { one: ACTION.TOUCH_ROTATE, two: ACTION.TOUCH_DOLLY_TRUCK, three: ACTION.NONE };
    orbit.dollyToCursor = true;
    orbit.minDistance = NEAREST;
    orbit.maxDistance = FARTHEST;
    this.orbit = orbit;
    this.fly = new FlyControls(canvas, orbit, host.isEnabled, host.isFlat);
    canvas.addEventListener('pointerdown', this.chooseAction, true);
    canvas.addEventListener('keydown', this.keyDown);
  }

  /** Whether one finger orbits; two always pan and zoom. */
  set oneFinger(orbits: boolean) {
    this.orbit.touches.one = orbits ? ACTION.TOUCH_ROTATE : ACTION.NONE;
  }

  /** Registers the pointer listeners again, so that they run after the canvas's other listeners. */
  listenLast(): void {
    this.orbit.disconnect();
    this.orbit.connect(this.canvas);
  }

  dispose(): void {
    this.canvas.removeEventListener('pointerdown', this.chooseAction, true);
    this.canvas.removeEventListener('keydown', this.keyDown);
    this.fly.dispose();
    this.orbit.dispose();
  }

  private readonly chooseAction = (event: PointerEvent): void => {
    this.orbit.mouseButtons.left = event.shiftKey ? ACTION.TRUCK : ACTION.ROTATE;
  };

  private readonly keyDown = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.host.isEnabled() || !this.host.hasKeys()) return;
    const {
      azimuth = 0,
      polar = 0,
      right = 0,
      up = 0,
      closer = 0,
    } = nudges[event.shiftKey && event.key.length > 1 ? `Shift+${event.key}` : event.key] ?? {};
    const { orbit } = this;
    if (azimuth !== 0 || polar !== 0) void orbit.rotate(azimuth, polar, true);
    else if (right !== 0 || up !== 0) void orbit.truck(right * orbit.distance, -up * orbit.distance, true);
    else if (closer !== 0) void orbit.dolly(closer * orbit.distance, true);
    else return;
    event.preventDefault();
  };
}
