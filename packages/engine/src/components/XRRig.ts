import { angle, boolean, number } from '@farol/editing/fields';
import { component } from '../core/Component';

/**
 * Floor on which a user of a headset stands: the object's origin is between the feet. The left stick walks, the right
 * one turns by steps, and shows a teleport target while it is pushed forward. With a CharacterController on the same
 * object, walking collides. A session drives it, see `@farol/engine/xr`; without one it does nothing.
 */
export class XRRig extends component({
  speed: number(2, { unit: 'm/s', min: 0, step: 0.5, help: 'Walking speed of a stick pushed fully; 0 for none.' }),
  turnStep: angle(Math.PI / 6, { min: 0, max: Math.PI, help: 'Turn of one push to the side.', label: 'Turn step' }),
  teleports: boolean(true, { help: 'A stick held forward and let go teleports.' }),
}) {
  static override readonly typeName: string = 'XRRig';
  static override readonly icon: string = 'character';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Where a headset stands; walks, turns and teleports.';
}
