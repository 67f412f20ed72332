import { type Camera, Color, type Light, Matrix4, type PointLight, Vector3 } from 'three';
import { LightField } from '../light-fields/LightField';
import { classifyLight } from '../lights/classifyLight';
import { fieldCount } from '../lights/lightData';
import { boundLight, sphereOutsidePlanes, ViewSpace } from '../lights/spheres';
import { lightRange } from '../lights/lightData';

/** One light that can be drawn without other lights. */
export interface LightPart {
  readonly light: Light;
  /** Index in a light field; null for a light that is an object, or a whole field. */
  readonly index: number | null;
}

const position = new Vector3();

/** Whether a light is an ambient or hemisphere light, which has no position. */
export const isAmbient = (light: Light): boolean => {
  const kind = classifyLight(light);
  return kind === 'ambient' || kind === 'hemisphere';
};

/** Single lights whose range a camera sees, and light objects that draw any of them. */
export class LightParts {
  readonly all: LightPart[] = [];
  /** Lights of negative intensity, which only show together with other lights. */
  readonly negative: LightPart[] = [];
  /** Copies of the host's light fields, with some of their lights. */
  private readonly copies = new Map<LightField, LightField>();
  private readonly space = new ViewSpace();
  private readonly sphere = new Float64Array(4);
  private readonly cone = new Float64Array(4);

  /** @param lights - managed lights that the camera's layers see, without ambient ones */
  constructor(lights: readonly Light[], camera: Camera) {
    this.space.begin(camera);
    for (const light of lights) {
      if ((light as LightField).isLightField) this.addField(light as LightField);
      else if (this.mayReach(light)) (takesLight(light) ? this.negative : this.all).push({ light, index: null });
    }
  }

  /** Light objects that draw the given parts. */
  lightsOf(parts: readonly LightPart[]): Light[] {
    const lights: Light[] = [];
    const counts = new Map<LightField, number>();
    for (const { light, index } of parts) {
      if (index === null) {
        lights.push(light);
        continue;
      }
      const field = light as LightField;
      const copy = this.copies.get(field)!;
      const at = counts.get(copy) ?? 0;
      if (at === 0) lights.push(copy);
      counts.set(copy, at + 1);
      copyLight(field, index, copy, at);
    }
    for (const [copy, count] of counts) copy.count = count;
    return lights;
  }

  private mayReach(light: Light): boolean {
    if (light.intensity === 0) return false;
    const kind = classifyLight(light);
    if (kind !== 'point' && kind !== 'extended-point' && kind !== 'spot') return true;
    this.sphere[3] = lightRange(light as PointLight);
    return boundLight(light, this.space, this.sphere, this.cone, 0);
  }

  private addField(field: LightField): void {
    if (field.textures !== null) {
      this.all.push({ light: field, index: null });
      return;
    }
    const { array } = field.spheres;
    const toView = new Matrix4().multiplyMatrices(this.space.view, field.matrixWorld);
    const first = this.all.length;
    for (let i = 0; i < fieldCount(field); i++) {
      const { x, y, z } = position.fromArray(array, i * 4).applyMatrix4(toView);
      const range = array[i * 4 + 3];
      if (range > 0 && !sphereOutsidePlanes(this.space.planes, x, y, z, range))
        this.all.push({ light: field, index: i });
    }
    const count = this.all.length - first;
    if (count === 0) return;
    const copy = new LightField(count, { spots: field.cones !== null });
    copy.name = field.name;
    copy.color = new Color().copy(field.color);
    copy.intensity = field.intensity;
    copy.layers.mask = field.layers.mask;
    copy.matrixWorld.copy(field.matrixWorld);
    this.copies.set(field, copy);
  }
}

function takesLight({ color: { r, g, b }, intensity }: Light): boolean {
  return Math.min(r * intensity, g * intensity, b * intensity) < 0;
}

function copyLight(from: LightField, light: number, to: LightField, at: number): void {
  const copy = (a: LightField['spheres'], b: LightField['spheres']): void => {
    const i = light * 4;
    b.set(at, a.array[i], a.array[i + 1], a.array[i + 2], a.array[i + 3]);
  };
  copy(from.spheres, to.spheres);
  copy(from.emissions, to.emissions);
  if (from.cones !== null && to.cones !== null) copy(from.cones, to.cones);
}

/** Position of a part (m, world space); null for a directional light and a whole field. */
export function placeOf({ light, index }: LightPart, to: Vector3): Vector3 | null {
  if (index !== null)
    return to.fromArray((light as LightField).spheres.array, index * 4).applyMatrix4(light.matrixWorld);
  const kind = classifyLight(light);
  return kind === 'directional' || kind === 'field' || kind === 'other'
    ? null
    : to.setFromMatrixPosition(light.matrixWorld);
}
