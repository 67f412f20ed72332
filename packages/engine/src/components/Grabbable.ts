import { boolean, number } from '@farol/editing/fields';
import { component } from '../core/Component';

/**
 * An object that can be grabbed in a headset by the grip button or a pinch, near the hand or where its ray points; with
 * a RigidBody it is thrown on release. A session drives it, see `@farol/engine/xr`.
 */
export class Grabbable extends component({
  reach: number(0.15, {
    unit: 'm',
    min: 0,
    step: 0.05,
    help: 'Distance to the hand within which it is taken.',
    label: 'Hand reach',
  }),
  far: boolean(true, { help: 'Also taken from afar, where a hand points at it.', label: 'From afar' }),
}) {
  static override readonly typeName: string = 'Grabbable';
  static override readonly icon: string = 'body';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Hands of a headset take, hold and throw it.';
}
