import { type Object3D, Quaternion, Vector3 } from 'three';
import type { EngineKeyEvent, EnginePointerEvent } from '../core/events';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import { toVector3, type Vector3Input } from '../core/toVector3';
import { characterFields } from '../physics/characterFields';
import type { CharacterControl } from '../physics/CharacterControl';
import { physicsComponent } from '../physics/physicsComponent';
import { TouchStick } from './TouchStick';

const UP = new Vector3(0, 1, 0);
const RIGHT = new Vector3(1, 0, 0);
/** Greatest duration (s) and drag (CSS pixels) of a tap that makes the character jump. */
const TAP_TIME = 0.25;
const TAP_REACH = 10;
/** Deflection of a gamepad's stick that is ignored, 0 to 1. */
const DEAD_ZONE = 0.15;
/** Turning speed at full deflection of a gamepad's stick (rad/s). */
const PAD_TURN = 2.5;

const turn = new Quaternion();
const front = new Vector3();
const worldTurn = new Quaternion();

const cameraBelow = (object: GameObject): Object3D | null => {
  for (const child of object.children) {
    if (child.getComponent('Camera')) return child.object3D;
    const found = cameraBelow(child);
    if (found) return found;
  }
  return null;
};

const alive = (value: number): number => (Math.abs(value) < DEAD_ZONE ? 0 : value);

/** First gamepad with the standard mapping; null for none. */
function standardPad(): Gamepad | null {
  try {
    const pads = globalThis.navigator?.getGamepads?.();
    return pads?.find((each) => each?.connected && each.mapping === 'standard') ?? null;
  } catch {
    // getGamepads() throws in an iframe without permission for gamepads
    return null;
  }
}

/**
 * Walks a GameObject through the scene's colliders: up steps and slopes, jumping, pushing what is in its way. Its
 * origin is at its feet. Keys, gamepad and fingers move it, and turn it together with its child camera; scripts call
 * `walk` and `jump`. Its motion is simulation: it is not saved, and `scene.reset()` undoes it.
 */
export class CharacterController extends physicsComponent(characterFields) {
  static override readonly typeName: string = 'CharacterController';
  static override readonly icon: string = 'character';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Walks by keys, gamepad or touch: steps, slopes, jumps.';
  static override readonly callable: readonly string[] = ['jump', 'teleport'];

  /** @internal Read and written by the physics. */
  readonly control: CharacterControl = {
    wish: new Vector3(),
    isRunning: false,
    wantsJump: false,
    teleport: null,
    velocity: new Vector3(),
    isGrounded: false,
  };

  private readonly held = new Set<string>();
  /** Direction that a script has passed to `walk`; null for none. */
  private requestedMove: Vector3 | null = null;
  private readonly stick = new TouchStick();
  private readonly finger = { pointer: -1, since: 0, way: 0 };
  private pitch = 0;
  private wasPadJump = false;

  /** Whether the character stands on the ground. */
  get isGrounded(): boolean {
    return this.control.isGrounded;
  }

  /** Velocity in the world (m/s): a copy. */
  get velocity(): Vector3 {
    return this.control.velocity.clone();
  }

  /**
   * Walks until called with zeros; keys are ignored meanwhile.
   * @param direction - in the world; its length is the share of walking speed, at most 1
   */
  walk(direction: Vector3Input): void {
    const asked = toVector3(direction, new Vector3()).setY(0).clampLength(0, 1);
    this.requestedMove = asked.lengthSq() > 0 ? asked : null;
  }

  /** Makes the character jump, if it stands on the ground. */
  jump(): void {
    this.control.wantsJump = true;
  }

  /** Moves the character at once. @param position - of the feet in the world (m) */
  teleport(position: Vector3Input): void {
    this.control.teleport = toVector3(position, new Vector3());
  }

  override onLeaveScene(scene: Scene): void {
    this.letGo();
    super.onLeaveScene(scene);
  }

  override onActiveChanged(): void {
    if (!this.isActive) this.letGo();
    super.onActiveChanged();
  }

  override start(): void {
    const camera = cameraBelow(this.gameObject);
    this.pitch = camera
      ? Math.asin(Math.max(-1, Math.min(1, front.set(0, 0, -1).applyQuaternion(camera.quaternion).y)))
      : 0;
  }

  override onDestroy(): void {
    this.letGo();
    this.requestedMove = null;
    this.control.teleport = null;
    this.control.isGrounded = false;
    this.control.velocity.set(0, 0, 0);
  }

  override onKeyDown(event: EngineKeyEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.code === 'Space' && !this.held.has('Space') && this.keys) this.jump();
    this.held.add(event.code);
  }

  override onKeyUp(event: EngineKeyEvent): void {
    this.held.delete(event.code);
  }

  override onPointerDown(event: EnginePointerEvent): void {
    if (event.pointerType !== 'touch') return;
    const { finger } = this;
    if ((!this.keys || !this.stick.press(event)) && finger.pointer < 0) {
      Object.assign(finger, { pointer: event.pointerId, since: this.scene?.time ?? 0, way: 0 });
    }
  }

  override onPointerMove(event: EnginePointerEvent): void {
    const { finger } = this;
    this.stick.move(event);
    if (event.pointerType !== 'touch') {
      if (this.look === 'move' || (this.look === 'drag' && (event.buttons & 1) !== 0)) this.turnBy(event.dx, event.dy);
    } else if (event.pointerId === finger.pointer) {
      finger.way += Math.abs(event.dx) + Math.abs(event.dy);
      if (this.look !== 'none') this.turnBy(event.dx, event.dy);
    }
  }

  override onPointerUp(event: EnginePointerEvent): void {
    const { finger } = this;
    this.stick.lift(event);
    if (event.pointerType !== 'touch' || event.pointerId !== finger.pointer) return;
    finger.pointer = -1;
    const isTap = finger.way < TAP_REACH && (this.scene?.time ?? 0) - finger.since < TAP_TIME;
    if (isTap && this.keys) this.jump();
  }

  override update(deltaSeconds: number): void {
    const { control, stick, held } = this;
    const { wish } = control;
    if (this.requestedMove) {
      wish.copy(this.requestedMove);
      return;
    }
    wish.set(0, 0, 0);
    control.isRunning = false;
    if (!this.keys) return;
    wish.x = this.direction('KeyD', 'ArrowRight') - this.direction('KeyA', 'ArrowLeft') + stick.right;
    wish.z = this.direction('KeyS', 'ArrowDown') - this.direction('KeyW', 'ArrowUp') + stick.back;
    control.isRunning = held.has('ShiftLeft') || held.has('ShiftRight');
    this.readPad(deltaSeconds);
    wish.clampLength(0, 1);
    if (wish.lengthSq() === 0) return;
    // turns the wished direction by the heading alone, so that a pitch does not slow walking along the ground
    this.gameObject.object3D.getWorldQuaternion(worldTurn);
    front.set(0, 0, -1).applyQuaternion(worldTurn);
    wish.applyAxisAngle(UP, Math.atan2(-front.x, -front.z));
  }

  private readPad(deltaSeconds: number): void {
    const pad = standardPad();
    if (!pad) return;
    const { axes, buttons } = pad;
    const { control } = this;
    control.wish.x += alive(axes[0] ?? 0);
    control.wish.z += alive(axes[1] ?? 0);
    // a press of the left stick (button 10) or the left shoulder (button 4) makes the character run
    if (buttons[10]?.pressed || buttons[4]?.pressed) control.isRunning = true;
    const isJump = buttons[0]?.pressed ?? false;
    if (isJump && !this.wasPadJump) this.jump();
    this.wasPadJump = isJump;
    if (this.look === 'none') return;
    const way = (PAD_TURN * deltaSeconds) / Math.max(Math.abs(this.lookSpeed), 1e-6);
    const [right, down] = [alive(axes[2] ?? 0), alive(axes[3] ?? 0)];
    if (right !== 0 || down !== 0) this.turnBy(right * way, down * way);
  }

  /**
   * Turns the character and its camera by a pointer movement.
   * @param right - movement to the right (CSS pixels); `down`: movement down
   */
  private turnBy(right: number, down: number): void {
    const { object3D } = this.gameObject;
    object3D.quaternion.premultiply(turn.setFromAxisAngle(UP, -right * this.lookSpeed));
    const camera = cameraBelow(this.gameObject);
    if (!camera) return;
    const limit = Math.max(this.pitchLimit, Math.abs(this.pitch));
    const pitch = Math.min(limit, Math.max(-limit, this.pitch - down * this.lookSpeed));
    camera.quaternion.multiply(turn.setFromAxisAngle(RIGHT, pitch - this.pitch));
    this.pitch = pitch;
  }

  private letGo(): void {
    this.held.clear();
    this.stick.letGo();
    this.finger.pointer = -1;
    this.control.wish.set(0, 0, 0);
    this.control.wantsJump = false;
  }

  private direction(key: string, arrow: string): number {
    return this.held.has(key) || this.held.has(arrow) ? 1 : 0;
  }
}
