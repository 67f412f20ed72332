import {
  type Camera,
  Color,
  type DirectionalLight,
  type Light,
  type Matrix4,
  type PointLight,
  type RectAreaLight,
  type SpotLight,
  Vector3,
} from 'three';
import type { DataTable } from '../gpu/DataTable';
import type { AreaLightTable } from './area-lights/AreaLightTable';
import { isAreaLight, mayBeMasked, type MaskSettings } from '../lights/classifyLight';
import type { FarolAttenuation, FarolLightData } from '../lights/lightData';
import { lightAxis } from '../lights/spheres';
import {
  AREA_PENUMBRA,
  attenuationKinds,
  emissionDecay,
  EXTENSION,
  FLOATS_PER_RECORD,
  LIGHT,
  NO_EXPONENT,
  POINT_CUTOFF,
  POINT_PENUMBRA,
} from '../lights/lightRecord';

const NO_DATA: FarolLightData = {};
const axis = new Vector3();
const colour = new Color();

/**
 * Source of mask records: per-light data of shadow map, cookie and layers, stored in the light table beside the lights.
 */
export interface LightMasks {
  /** Number of mask records of the frame. */
  readonly records: number;
  /**
   * Index of a light's mask record, counted from the first mask record; -1 for a light without a mask. ELSEWHERE is
   * added for a point light that has moved since its shadow map was drawn, so that `isMaskedPoint` is false for it.
   */
  recordOf(light: Light): number;
  /** Writes the mask records to the light table, beginning at record `first`. */
  write(table: DataTable, first: number, camera: Camera): void;
}

/** Settings of shadow maps, cookies and layers, and the writer of area lights' extension records. */
export interface RecordSettings extends MaskSettings {
  /** Writer of area-light records; null until the code of area lights is loaded. Default null. */
  readonly areas?: AreaLightTable | null;
}

/** Writes lights as records of the light table, and extension records for lights with Farol's options. */
export class LightRecords {
  /** Number of extension records written since `begin`. */
  extensions = 0;
  private firstMask = 0;
  private firstExtension = 0;
  private slots = 0;
  private masks: LightMasks | null = null;
  private settings: RecordSettings | null = null;

  constructor(private readonly table: DataTable) {}

  /**
   * Begins a frame.
   * @param firstMask - record of the first mask; extensions follow the masks
   * @param settings - settings that tell which lights may have a mask
   * @param slots - number of records of light fields, which shaders read before the masks, besides those of the table
   */
  begin(masks: LightMasks | null, firstMask: number, settings: RecordSettings | null, slots = 0): void {
    this.masks = masks;
    this.settings = settings;
    this.slots = slots;
    this.firstMask = firstMask;
    this.firstExtension = firstMask + (masks?.records ?? 0);
    this.extensions = 0;
  }

  writeDirectional(record: number, light: DirectionalLight, view: Matrix4): void {
    const { table } = this;
    const at = record * FLOATS_PER_RECORD;
    lightAxis(light, view, axis);
    const extension = this.writeExtension(light);
    const mask = this.maskOf(light);
    const { r, g, b } = light.color;
    const i = light.intensity;
    table.set4(at + LIGHT.sphere, axis.x, axis.y, axis.z, 0);
    if (extension > 0) table.set4(at + LIGHT.emission, colour.r, colour.g, colour.b, 1);
    else table.set4(at + LIGHT.emission, r * i, g * i, b * i, mask > 0 ? 1 : 0);
    table.set4(at + LIGHT.details, 0, 0, mask, extension);
  }

  /**
   * Writes the record of a point, spot or area light whose centre (view space, m) is given.
   * @param range - range of the light (m)
   * @returns whether the record is that of a plain point light
   */
  writeLocal(record: number, light: Light, x: number, y: number, z: number, range: number, view: Matrix4): boolean {
    const { table } = this;
    const at = record * FLOATS_PER_RECORD;
    const point = light as PointLight;
    const spot = (light as SpotLight).isSpotLight === true ? (light as SpotLight) : null;
    const isArea = isAreaLight(light);
    const extension = isArea ? this.writeArea(light, view) : this.writeExtension(light);
    const mask = this.maskOf(light);
    const plain = spot === null && extension === 0 && mask === 0 && point.decay >= 0;
    const i = light.intensity;
    const decay = emissionDecay(point.decay ?? 0, plain);
    table.set4(at + LIGHT.sphere, x, y, z, range);
    if (extension > 0) table.set4(at + LIGHT.emission, colour.r, colour.g, colour.b, decay);
    else table.set4(at + LIGHT.emission, light.color.r * i, light.color.g * i, light.color.b * i, decay);
    if (spot !== null) {
      lightAxis(spot, view, axis);
      table.set4(at + LIGHT.cone, axis.x, axis.y, axis.z, Math.cos(spot.angle));
      const exponent = (spot.userData.farol as FarolLightData | undefined)?.spotExponent ?? NO_EXPONENT;
      table.set4(at + LIGHT.details, Math.cos(spot.angle * (1 - spot.penumbra)), exponent, mask, extension);
    } else if (!plain) {
      table.set4(at + LIGHT.cone, 0, 0, 1, POINT_CUTOFF);
      const penumbra = isArea ? AREA_PENUMBRA : POINT_PENUMBRA;
      table.set4(at + LIGHT.details, penumbra, NO_EXPONENT, mask, extension || mask % 1);
    }
    return plain;
  }

  /** Writes the extension record of an area light. @returns its record, as `writeExtension` */
  private writeArea(light: RectAreaLight, view: Matrix4): number {
    const record = this.firstExtension + this.extensions++;
    this.settings!.areas!.write(this.table, record * FLOATS_PER_RECORD, light, view);
    colour.copy(light.color).multiplyScalar(light.intensity);
    return record + this.slots;
  }

  /**
   * Writes the extension record, if the light needs one, and sets `colour` to the colour for the light's own record.
   */
  private writeExtension(light: Light): number {
    const data = (light.userData.farol as FarolLightData | undefined) ?? NO_DATA;
    const { specular, ambient, attenuation } = data;
    if (specular === undefined && ambient === undefined && attenuation === undefined) return 0;
    const { table } = this;
    const record = this.firstExtension + this.extensions++;
    const at = record * FLOATS_PER_RECORD;
    const i = light.intensity;
    const d = light.color;
    const s0 = specular ? specular[0] : d.r;
    const s1 = specular ? specular[1] : d.g;
    const s2 = specular ? specular[2] : d.b;
    const c0 = Math.max(d.r, s0);
    const c1 = Math.max(d.g, s1);
    const c2 = Math.max(d.b, s2);
    table.set4(at + EXTENSION.diffuse, ratio(d.r, c0), ratio(d.g, c1), ratio(d.b, c2), 0);
    table.set4(at + EXTENSION.specular, ratio(s0, c0), ratio(s1, c1), ratio(s2, c2), 0);
    if (ambient === undefined) table.set4(at + EXTENSION.ambient, 0, 0, 0, 0);
    else table.set4(at + EXTENSION.ambient, ambient[0] * i, ambient[1] * i, ambient[2] * i, 0);
    this.writeAttenuation(at + EXTENSION.falloff, attenuation);
    colour.setRGB(c0 * i, c1 * i, c2 * i);
    return record + this.slots;
  }

  private writeAttenuation(at: number, attenuation: FarolAttenuation | undefined): void {
    if (attenuation === undefined) this.table.set4(at, 0, 0, 0, attenuationKinds.physical);
    else if (attenuation.kind === 'near-far')
      this.table.set4(at, finite(attenuation.near), finite(attenuation.far), 0, attenuationKinds.nearFar);
    else {
      const { constant, linear, quadratic } = attenuation;
      this.table.set4(at, finite(constant), finite(linear), finite(quadratic), attenuationKinds.polynomial);
    }
  }

  private maskOf(light: Light): number {
    if (this.masks === null || this.settings === null || !mayBeMasked(light, this.settings)) return 0;
    const record = this.masks.recordOf(light);
    return record < 0 ? 0 : this.firstMask + this.slots + record;
  }
}

/** Replaces NaN by 0 and an infinity by a large finite number, so that `x - x` is 0 and not NaN. */
function finite(value: number): number {
  return Math.max(-1e30, Math.min(1e30, value || 0));
}

function ratio(part: number, whole: number): number {
  return whole > 0 ? part / whole : 1;
}
