import { type Camera, type Light, Vector3 } from 'three';
import type { FoundLights } from '../lights/FoundLights';
import { POINT } from '../lights/plainPoints';
import type { VisibleLights } from '../lights/VisibleLights';
import { sphereOutsidePlanes, viewFrustumPlanes } from '../lights/spheres';
import { LightField, MOST } from './LightField';

/** Greatest values of lights that shaders of fields light, see fieldLight.glsl. */
const LONGEST_RANGE = 1e14;
const BRIGHTEST = 1e30;
const FASTEST_DECAY = 1e3;
/** Distance (m) of the camera from the field's origin from which on the origin moves: 32-bit floats then still step by 0.1 mm. */
const FARTHEST = 1000;
/** One light in so many is tested in each frame for whether the camera sees it. */
const SAMPLED = 64;
/** Share of lights that the camera must see, to begin and to go on. The GPU lists all lights, the CPU only those in view. */
const BEGINS = 0.5;
const GOES_ON = 0.4;

const planes = new Float64Array(24);

/**
 * Plain point lights of a scene, thousands of objects, as one LightField: the GPU then brings them to view space, sorts and packs
 * them, and the CPU only compares their values with those of the last frame.
 */
export class PackedLights {
  /** Lights of the last `pack` that are not in the field. */
  readonly rest: Light[] = [];
  /** Share of the lights in the field that the camera sees, estimated over the last frames. */
  share = 0;
  private field: LightField | null = null;
  private readonly origin = new Vector3();
  private phase = 0;
  private tested = 0;
  private seen = 0;

  /** Whether so many lights are in view that packing pays. @param lights - lights of the last frame */
  pays({ fields, visible, total }: VisibleLights): boolean {
    const { field } = this;
    if (field !== null && fields.includes(field)) return this.share >= GOES_ON;
    this.share = visible / total;
    return this.share >= BEGINS;
  }

  /** Writes the lights found to the field, and the others to `rest`. World matrices and `found.points` must be up to date. */
  pack({ all, count, points }: FoundLights, camera: Camera): LightField {
    const { rest } = this;
    const field = this.fieldFor(Math.min(count, MOST));
    this.follow(field, camera);
    const { x: ox, y: oy, z: oz } = this.origin;
    const { spheres, emissions } = field;
    const { array: s } = spheres;
    const { array: e } = emissions;
    // number of lights up to which the rows of 128 are marked as changed
    let moved = 0;
    let changed = 0;
    let left = 0;
    let n = 0;
    for (let i = 0; i < count; i++) {
      const p = i * POINT;
      const range = points[p + 3];
      const decay = points[p + 7];
      const r = Math.fround(points[p + 4]);
      const g = Math.fround(points[p + 5]);
      const b = Math.fround(points[p + 6]);
      // false for NaN, the decay of lights that are no plain point lights
      const isPlain = range > 0 && range <= LONGEST_RANGE && decay >= 0 && decay <= FASTEST_DECAY;
      if (!isPlain || Math.abs(r) + Math.abs(g) + Math.abs(b) > BRIGHTEST || n === field.capacity) {
        rest[left++] = all[i];
        continue;
      }
      const at = n * 4;
      const x = Math.fround(points[p] - ox);
      const y = Math.fround(points[p + 1] - oy);
      const z = Math.fround(points[p + 2] - oz);
      const w = Math.fround(range);
      if (s[at] !== x || s[at + 1] !== y || s[at + 2] !== z || s[at + 3] !== w) {
        s[at] = x;
        s[at + 1] = y;
        s[at + 2] = z;
        s[at + 3] = w;
        if (n >= moved) {
          spheres.update(n, 1);
          moved = (n | 127) + 1;
        }
      }
      const falloff = Math.fround(decay);
      if (e[at] !== r || e[at + 1] !== g || e[at + 2] !== b || e[at + 3] !== falloff) {
        e[at] = r;
        e[at + 1] = g;
        e[at + 2] = b;
        e[at + 3] = falloff;
        if (n >= changed) {
          emissions.update(n, 1);
          changed = (n | 127) + 1;
        }
      }
      n++;
    }
    rest.length = left;
    field.count = n;
    this.estimate(field, camera);
    return field;
  }

  dispose(): void {
    this.field?.dispose();
    this.field = null;
    this.rest.length = 0;
  }

  private fieldFor(count: number): LightField {
    if (this.field !== null && this.field.capacity >= count) return this.field;
    this.field?.dispose();
    return (this.field = new LightField(Math.min(MOST, Math.ceil(count * 1.5))));
  }

  /** Keeps the field's origin near the camera. */
  private follow(field: LightField, { matrixWorld }: Camera): void {
    const { 12: x, 13: y, 14: z } = matrixWorld.elements;
    const { origin } = this;
    const distance = Math.max(Math.abs(x - origin.x), Math.abs(y - origin.y), Math.abs(z - origin.z));
    if (distance > FARTHEST) origin.set(x, y, z);
    field.matrixWorld.makeTranslation(origin.x, origin.y, origin.z);
  }

  /** Tests one light in SAMPLED, other ones in each frame, for whether the camera sees it. */
  private estimate({ count, spheres: { array } }: LightField, camera: Camera): void {
    const { elements: m } = camera.matrixWorldInverse;
    const { origin } = this;
    viewFrustumPlanes(camera.projectionMatrix.elements, planes);
    for (let i = this.phase; i < count; i += SAMPLED) {
      const x = array[i * 4] + origin.x;
      const y = array[i * 4 + 1] + origin.y;
      const z = array[i * 4 + 2] + origin.z;
      const vx = m[0] * x + m[4] * y + m[8] * z + m[12];
      const vy = m[1] * x + m[5] * y + m[9] * z + m[13];
      const vz = m[2] * x + m[6] * y + m[10] * z + m[14];
      this.tested++;
      if (!sphereOutsidePlanes(planes, vx, vy, vz, array[i * 4 + 3])) this.seen++;
    }
    if (++this.phase < SAMPLED) return;
    this.share = this.seen / Math.max(1, this.tested);
    this.phase = this.seen = this.tested = 0;
  }
}
