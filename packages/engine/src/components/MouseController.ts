import { angle, choice, number, vector3 } from '@farol/editing/fields';
import { Quaternion, Vector3 } from 'three';
import type { EnginePointerEvent } from '../core/events';
import { component } from '../core/Component';
import { KeyController } from './KeyController';

const BUTTONS: Record<string, number> = { left: 1, right: 2, middle: 4, any: 7 };

const turn = new Quaternion();
const axis = new Vector3();
const front = new Vector3();

/**
 * Turns a GameObject by dragging over the canvas, with the mouse or a finger: sideways about an axis of the world, up
 * and down about one of its own, so that it never tilts (thesis 3.2.5.5). The rotation is simulation: it is not saved,
 * and `scene.reset()` undoes it.
 */
export class MouseController extends component({
  horizontalAxis: vector3([0, 1, 0], {
    help: "The world's axis that sideways motion turns about.",
    label: 'Sideways axis',
  }),
  verticalAxis: vector3([1, 0, 0], {
    help: 'Own axis that up and down motion turns about.',
    label: 'Up and down axis',
  }),
  speed: number(0.004, { unit: 'rad/px', step: 0.001, help: 'Turn for each pixel of motion; below 0 it is inverted.' }),
  button: choice('left', ['left', 'middle', 'right', 'any', 'none'], {
    help: "Button that must be held; 'none' turns at every motion.",
  }),
  pitchLimit: angle(1.5, {
    min: 0,
    max: Math.PI / 2,
    help: 'Greatest angle of the front above or below the horizon.',
    label: 'Pitch limit',
  }),
}) {
  static override readonly typeName: string = 'MouseController';
  static override readonly icon: string = 'mouse';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Rotation by the mouse or a finger.';

  override onPointerMove(event: EnginePointerEvent): void {
    if (this.button !== 'none' && (event.buttons & BUTTONS[this.button]) === 0) return;
    if (this.gameObject.getComponent(KeyController)?.isMovedBy(event)) return;
    if (event.dx !== 0) this.turnSideways(-event.dx * this.speed);
    if (event.dy !== 0) this.turnUpwards(-event.dy * this.speed);
  }

  private turnSideways(radians: number): void {
    const { object3D } = this.gameObject;
    axis.set(...this.horizontalAxis).normalize();
    object3D.quaternion.premultiply(turn.setFromAxisAngle(axis, radians));
  }

  private turnUpwards(radians: number): void {
    const { object3D } = this.gameObject;
    axis.set(...this.horizontalAxis).normalize();
    front.set(0, 0, -1).applyQuaternion(object3D.quaternion);
    const pitch = Math.asin(Math.min(1, Math.max(-1, front.dot(axis))));
    const limit = Math.max(this.pitchLimit, Math.abs(pitch));
    const allowed = Math.min(limit, Math.max(-limit, pitch + radians)) - pitch;
    axis.set(...this.verticalAxis).normalize();
    object3D.quaternion.multiply(turn.setFromAxisAngle(axis, allowed));
  }
}
