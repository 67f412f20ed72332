import { Light } from 'three';
import { LightArray } from './LightArray';
import { lightFieldMade } from '../lights/lightFieldMade';
import type { LightTextures } from './LightTextures';

/** Options of the constructor of LightField. */
export interface LightFieldOptions {
  /** Whether some of the lights are spot lights. Default false: memory and shaders only for point lights. */
  spots?: boolean;
  /** Textures with lights that the GPU writes, in place of arrays. Default null. */
  textures?: LightTextures | null;
}

/** Maximum number of lights of a field. */
export const MOST = 2 ** 18;

/**
 * Many point and spot lights as data: to PointLight and SpotLight what InstancedMesh is to Mesh. FarolRenderer draws them
 * like as many lights of three's, with every technique, at no CPU cost per light; stock three ignores them. Positions and
 * directions are in the space of the field, which `matrixWorld` transforms; ranges are in metres at any scale, as for
 * three's lights. `color` and `intensity` of the field (default white, 1) multiply all its lights. A light with a range
 * of 0 or less, or with a value that is not a finite number, gives no light. Lights of a field have no shadows, cookies
 * or layers, and must have a range.
 *
 * @example
 * const field = new LightField(10_000);
 * for (let i = 0; i < 10_000; i++) field.setPoint(i, x(i), 1, z(i), 1, 4, 3, 2);
 * scene.add(field);
 * // in each frame
 * for (let i = 0; i < 10_000; i++) field.setPosition(i, x(i), 1, z(i));
 */
export class LightField extends Light {
  readonly isLightField = true;
  override readonly type = 'LightField';
  /** Maximum number of lights of this field. */
  readonly capacity: number;
  /** Number of lights drawn, from the first on. At most, and by default, `capacity`. */
  override count: number;
  /** Position in the field's space (m), range (m) of each light. Empty where `textures` are given. */
  readonly spheres: LightArray;
  /** Linear colour times intensity (cd), decay of each light. */
  readonly emissions: LightArray;
  /**
   * Four numbers for each light: xyz: direction of its light, in the field's space, with the length 2 + cosine of the angle
   * where it begins to fade (angle × (1 - penumbra)); w: cosine of its angle. Zeros: a point light. Null without `spots`.
   */
  readonly cones: LightArray | null;
  /** Textures with the lights, in place of the arrays; null to use the arrays. May be replaced. */
  textures: LightTextures | null;

  /**
   * Starts to fetch the code that draws fields.
   * @param capacity - maximum number of lights, at most 262,144
   * @throws RangeError for other capacities
   */
  constructor(capacity: number, options: LightFieldOptions = {}) {
    super(0xffffff, 1);
    if (!(capacity >= 0 && capacity <= MOST))
      throw new RangeError(`LightField: capacity is ${capacity}; give a number from 0 to ${MOST}.`);
    const { spots = false, textures = null } = options;
    this.count = this.capacity = Math.floor(capacity);
    this.textures = textures;
    const room = textures === null ? this.capacity : 0;
    this.spheres = new LightArray(room);
    this.emissions = new LightArray(room);
    this.cones = spots ? new LightArray(room) : null;
    lightFieldMade.tell();
  }

  /**
   * Sets a light to a point light.
   * @param r - linear colour times intensity (cd), with g and b
   * @throws RangeError when there is no such light
   */
  setPoint(
    light: number,
    x: number,
    y: number,
    z: number,
    range: number,
    r: number,
    g: number,
    b: number,
    decay = 2,
  ): void {
    this.check(light);
    this.spheres.set(light, x, y, z, range);
    this.emissions.set(light, r, g, b, decay);
    this.cones?.set(light, 0, 0, 0, 0);
  }

  /**
   * Turns a light that was set by `setPoint` into a spot light.
   * @param x - direction of its light, in the field's space, of any length above 0, with y and z
   * @param angle - angle from the direction to the edge of the cone (rad), above 0 and at most π / 2
   * @param penumbra - faded share of the angle, 0 to 1
   * @throws RangeError when there is no such light; Error when the field was made without `spots`
   */
  setCone(light: number, x: number, y: number, z: number, angle: number, penumbra = 0): void {
    this.check(light);
    if (this.cones === null)
      throw new Error('LightField: setCone() needs spot lights; make the field with { spots: true }.');
    const scale = (2 + Math.cos(angle * (1 - penumbra))) / Math.hypot(x, y, z);
    this.cones.set(light, x * scale, y * scale, z * scale, Math.cos(angle));
  }

  /** Moves a light, in the field's space (m). @throws RangeError when there is no such light */
  setPosition(light: number, x: number, y: number, z: number): void {
    this.check(light);
    this.spheres.set(light, x, y, z, this.spheres.array[light * 4 + 3]);
  }

  /** @param r - linear colour times intensity (cd), with g and b @throws RangeError when there is no such light */
  setEmission(light: number, r: number, g: number, b: number): void {
    this.check(light);
    this.emissions.set(light, r, g, b, this.emissions.array[light * 4 + 3]);
  }

  /** Sets the range of a light (m); 0 switches it off. @throws RangeError when there is no such light */
  setRange(light: number, range: number): void {
    this.check(light);
    const { array } = this.spheres;
    this.spheres.set(light, array[light * 4], array[light * 4 + 1], array[light * 4 + 2], range);
  }

  override clone(recursive?: boolean): this {
    const { capacity, cones, textures } = this;
    const clone = new LightField(capacity, { spots: cones !== null, textures }) as this;
    return clone.copy(this, recursive);
  }

  /** Copies another field of the same capacity. @throws RangeError when capacities differ */
  override copy(source: this, recursive?: boolean): this {
    if (source.capacity !== this.capacity)
      throw new RangeError(
        `LightField: copy() from capacity ${source.capacity} to ${this.capacity}; use clone() instead.`,
      );
    super.copy(source, recursive);
    this.count = source.count;
    this.textures = source.textures;
    copy(source.spheres, this.spheres);
    copy(source.emissions, this.emissions);
    if (source.cones !== null && this.cones !== null) copy(source.cones, this.cones);
    return this;
  }

  private check(light: number): void {
    if (light >= 0 && light < this.capacity && this.textures === null) return;
    throw this.textures === null
      ? new RangeError(`LightField: there is no light ${light}; give an index below ${this.capacity}.`)
      : new Error('LightField: the lights of this field are in textures; write those to set them.');
  }
}

function copy(from: LightArray, to: LightArray): void {
  to.array.set(from.array.subarray(0, to.array.length));
  to.update();
}
