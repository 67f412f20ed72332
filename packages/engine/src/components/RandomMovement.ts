import { number, vector3, type Vector3Tuple } from '@farol/editing/fields';
import { component } from '../core/Component';
import { createRandom } from '../base/createRandom';

/** Shares of the two waves of each axis; together 1, so that the object stays within its extent. */
const SHARES = [0.65, 0.35];

/**
 * Moves a GameObject around its authored position. The offset depends on the seed and the scene's time alone, so every
 * run is the same; at time 0 it is 0. Its motion is simulation, not an edit, and is not saved.
 */
export class RandomMovement extends component({
  seed: number(1, { integer: true, min: 0, max: 2 ** 31 - 1, help: 'Another number, another path.' }),
  extent: vector3([2, 0.5, 2], {
    unit: 'm',
    min: 0,
    step: 0.1,
    help: 'How far it goes from its place along each axis.',
  }),
  speed: number(1, { unit: 'm/s', min: 0, step: 0.1, help: 'Greatest speed along any one axis.' }),
}) {
  static override readonly typeName: string = 'RandomMovement';
  static override readonly icon: string = 'motion';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Perpetual motion round a place, the same in every run.';

  /** Signed angular speeds (rad/s) of the two waves of each axis, at 1 m/s and an extent of 1 m. */
  private readonly rates = new Float64Array(6);

  override onAttach(): void {
    this.chooseRates();
  }

  override onFieldChanged(name: string): void {
    if (name === 'seed') this.chooseRates();
  }

  override onDetach(): void {
    this.gameObject.transform.restoreAuthored();
  }

  override onActiveChanged(): void {
    if (!this.isActive) this.gameObject.transform.restoreAuthored();
  }

  /** Offset from the authored position along an axis (0 x, 1 y, 2 z) at a time (s); 0 at time 0. */
  offset(axis: number, time: number): number {
    return this.wave(axis, this.extent[axis], this.speed * time);
  }

  override update(_deltaSeconds: number, time: number): void {
    const { transform, object3D } = this.gameObject;
    const place = transform.getAuthored('position') as Vector3Tuple;
    const { extent } = this;
    const way = this.speed * time;
    object3D.position.set(
      place[0] + this.wave(0, extent[0], way),
      place[1] + this.wave(1, extent[1], way),
      place[2] + this.wave(2, extent[2], way),
    );
  }

  /**
   * Sum of the two waves of an axis.
   * @param extent - greatest offset (m)
   * @param way - distance travelled at full speed (m)
   */
  private wave(axis: number, extent: number, way: number): number {
    if (extent === 0) return 0;
    const { rates } = this;
    const phase = way / extent;
    return extent * (SHARES[0] * Math.sin(rates[axis * 2] * phase) + SHARES[1] * Math.sin(rates[axis * 2 + 1] * phase));
  }

  private chooseRates(): void {
    const random = createRandom(this.seed);
    for (let i = 0; i < 6; i++) this.rates[i] = (random() < 0.5 ? -1 : 1) * (0.45 + 0.55 * random());
  }
}
