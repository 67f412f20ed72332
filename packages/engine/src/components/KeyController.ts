import { number, string, vector3 } from '@farol/editing/fields';
import { Vector3 } from 'three';
import type { EngineKeyEvent, EnginePointerEvent } from '../core/events';
import { component } from '../core/Component';
import { TouchStick } from './TouchStick';

const move = new Vector3();
const axis = new Vector3();

/**
 * Moves a GameObject by keys along its own front and right axes, and up and down in the world (thesis 3.2.5.5); on a
 * touch screen by dragging a finger from the left half of the picture. Movement is simulation: not saved, and undone by
 * `scene.reset()`.
 */
export class KeyController extends component({
  front: vector3([0, 0, -1], { help: 'Own axis that the forward key follows.' }),
  right: vector3([1, 0, 0], { help: 'Own axis that the right key follows.' }),
  speed: number(5, { unit: 'm/s', min: 0, step: 0.5, help: 'Speed of the motion.' }),
  boost: number(4, { min: 1, max: 100, help: 'Factor of the speed while Shift is held.' }),
  forwardKey: string('KeyW', { help: "Key to go forward (KeyboardEvent's code).", label: 'Forward key' }),
  backwardKey: string('KeyS', { help: 'Key to go backward.', label: 'Backward key' }),
  leftKey: string('KeyA', { help: 'Key to go left.', label: 'Left key' }),
  rightKey: string('KeyD', { help: 'Key to go right.', label: 'Right key' }),
  upKey: string('KeyE', { help: 'Key to rise.', label: 'Up key' }),
  downKey: string('KeyQ', { help: 'Key to sink.', label: 'Down key' }),
}) {
  static override readonly typeName: string = 'KeyController';
  static override readonly icon: string = 'keyboard';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Motion by keys, or by a finger on the left half.';

  private readonly held = new Set<string>();
  private boosted = false;
  private readonly stick = new TouchStick();

  /** Whether the pointer is the finger that moves the object, which therefore must not turn it. */
  isMovedBy(event: EnginePointerEvent): boolean {
    return this.stick.isHeldBy(event);
  }

  override onKeyDown(event: EngineKeyEvent): void {
    this.boosted = event.shiftKey;
    if (!event.ctrlKey && !event.metaKey && !event.altKey) this.held.add(event.code);
  }

  override onKeyUp(event: EngineKeyEvent): void {
    this.boosted = event.shiftKey;
    this.held.delete(event.code);
  }

  override onPointerDown(event: EnginePointerEvent): void {
    this.stick.press(event);
  }

  override onPointerMove(event: EnginePointerEvent): void {
    this.stick.move(event);
  }

  override onPointerUp(event: EnginePointerEvent): void {
    this.stick.lift(event);
  }

  override onDetach(): void {
    this.letGo();
  }

  override onActiveChanged(): void {
    if (!this.isActive) this.letGo();
  }

  override update(deltaSeconds: number): void {
    const { stick } = this;
    if (this.held.size === 0 && stick.right === 0 && stick.back === 0) return;
    const { object3D } = this.gameObject;
    const ahead = this.direction(this.forwardKey, 'ArrowUp') - this.direction(this.backwardKey, 'ArrowDown');
    const forward = ahead - stick.back;
    const sideways =
      this.direction(this.rightKey, 'ArrowRight') - this.direction(this.leftKey, 'ArrowLeft') + stick.right;
    const upward = this.direction(this.upKey, 'PageUp') - this.direction(this.downKey, 'PageDown');
    const { front, right } = this;
    move.set(0, 0, 0).addScaledVector(axis.set(front[0], front[1], front[2]), forward);
    move.addScaledVector(axis.set(right[0], right[1], right[2]), sideways).applyQuaternion(object3D.quaternion);
    move.y += upward;
    if (move.lengthSq() === 0) return;
    const distance = this.speed * (this.boosted ? this.boost : 1) * deltaSeconds;
    object3D.position.addScaledVector(move.clampLength(0, 1), distance);
  }

  private letGo(): void {
    this.held.clear();
    this.stick.letGo();
  }

  private direction(key: string, arrow: string): number {
    return this.held.has(key) || this.held.has(arrow) ? 1 : 0;
  }
}
