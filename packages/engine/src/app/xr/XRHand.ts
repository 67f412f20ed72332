import {
  BoxGeometry,
  BufferGeometry,
  type Group,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  Vector3,
  type WebXRManager,
} from 'three';

/** Deflection of a stick that is ignored, 0 to 1. */
const DEAD_ZONE = 0.15;

const alive = (value: number): number => (Math.abs(value) < DEAD_ZONE ? 0 : value);

/** A hand of the user, a controller or a tracked hand, with its visible model. */
export class XRHand {
  /** Pose of the hand; invisible while the hand is not tracked. */
  readonly grip: Group;
  /** Pointing ray, along the group's -z. */
  readonly ray: Group;
  private source: XRInputSource | null = null;
  /** Number of pressed grab buttons: the grip, or a pinch. */
  private heldButtons = 0;
  private readonly visuals: readonly (Mesh | Line)[];
  private readonly endings: (() => void)[] = [];

  constructor(xr: WebXRManager, index: number, space: Object3D) {
    this.grip = xr.getControllerGrip(index);
    this.ray = xr.getController(index);
    const body = new Mesh(new BoxGeometry(0.04, 0.03, 0.12), new MeshStandardMaterial({ color: 0x404448 }));
    const beam = new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, -1)]);
    const line = new Line(beam, new LineBasicMaterial({ color: 0xffffff }));
    this.visuals = [body, line];
    this.grip.add(body);
    this.ray.add(line);
    space.add(this.grip, this.ray);
    const listen = (type: string, act: (event: { data?: XRInputSource }) => void): void => {
      const { ray } = this as { ray: Object3D };
      ray.addEventListener(type as never, act as never);
      this.endings.push(() => ray.removeEventListener(type as never, act as never));
    };
    listen('connected', ({ data }) => (this.source = data ?? null));
    listen('disconnected', () => {
      this.source = null;
      this.heldButtons = 0;
    });
    for (const button of ['select', 'squeeze']) {
      listen(`${button}start`, () => this.heldButtons++);
      listen(`${button}end`, () => (this.heldButtons = Math.max(0, this.heldButtons - 1)));
    }
  }

  get isLeft(): boolean {
    return this.source?.handedness === 'left';
  }

  get isThere(): boolean {
    return this.source !== null;
  }

  get isHolding(): boolean {
    return this.heldButtons > 0;
  }

  /** Deflection of the stick to the right, -1 to 1. */
  get right(): number {
    return alive(this.source?.gamepad?.axes[2] ?? 0);
  }

  /** Deflection of the stick towards the user, -1 to 1. */
  get back(): number {
    return alive(this.source?.gamepad?.axes[3] ?? 0);
  }

  dispose(): void {
    for (const end of this.endings) end();
    for (const object of this.visuals) {
      object.removeFromParent();
      object.geometry.dispose();
      (object.material as MeshStandardMaterial).dispose();
    }
    this.grip.removeFromParent();
    this.ray.removeFromParent();
  }
}
