import type { FieldTable, FieldValue } from '@farol/editing/fields';
import type { SurfaceUniforms } from '@farol/renderer/surfaces';
import { Color, type Material, type Vector3 } from 'three';
import { derivedMaterial } from './derivedMaterial';
import type { SurfaceAsset } from './SurfaceAsset';
import { surfaceCode } from './surfaceCode';
import { entryOf, readStored, storedValue } from '../fields/storedValues';
import { UNIFORM, uniformValues } from './uniformFields';
import { type TextureHost, writeSurfaceMaps } from './writeSurfaceMaps';

/** Values of a surface (GLSL on top of a material), as files store them. */
export interface LayerValues {
  /** Uniform values as JSON: see `surfaceValueFields`. */
  readonly text: string;
  /** Names of the surface's textures, in order of declaration. */
  readonly maps: readonly (string | null)[];
}

/** Uniform that a field writes, in full or one component such as 'x'. */
interface Target {
  readonly uniform: string;
  readonly axis: 'x' | 'y' | 'z' | 'w' | null;
}

const targets = new WeakMap<FieldTable, ReadonlyMap<string, Target>>();

/** Uniforms that the fields of a surface write, by field name; computed once for each table. */
function targetsOf(table: FieldTable): ReadonlyMap<string, Target> {
  let found = targets.get(table);
  if (!found) {
    const list = Object.keys(table).map((name): [string, Target] => {
      const [uniform, axis = null] = name.slice(UNIFORM.length).split('.');
      return [name, { uniform, axis: axis as Target['axis'] }];
    });
    targets.set(table, (found = new Map(list)));
  }
  return found;
}

/**
 * Copy of a material with one more surface (GLSL) on top, for some of the objects that use the material. It inherits
 * all else, live, from that source material, which is never changed.
 */
export class LayeredMaterial {
  readonly material: Material;
  users = 1;
  private uniforms: SurfaceUniforms = {};

  /**
   * @param key - key by which users share the material; null for the material of one user
   * @param asset - surface asset, already compiled
   */
  constructor(
    readonly source: Material,
    readonly asset: SurfaceAsset,
    public key: string | null,
    private values: LayerValues,
    private readonly textures: TextureHost,
  ) {
    this.material = derivedMaterial(source, { userData: { ...source.userData, surface: asset.name } });
    source.addEventListener('dispose', this.sourceDisposed);
    this.refresh();
  }

  /** Sets the values of the material's surface, for all users of the material. */
  change(values: LayerValues): void {
    this.values = values;
    this.refresh();
  }

  /** Updates the surfaces after the asset's text or the source's surface changed. */
  refresh(): void {
    const code = surfaceCode.code;
    const { surface, surfaceFields } = this.asset;
    if (!code || !surface) return;
    const { text, maps } = this.values;
    const stored = readStored(text);
    const given = uniformValues(surface.uniforms, (name) => storedValue(surfaceFields[name], stored[entryOf(name)]));
    this.uniforms = code.layerSurface(this.material, this.source, surface, given);
    const worn = code.getSurfaces(this.material).map((each) => each.surface.name);
    // lists the surfaces for readers of three's materials, such as an exporter
    this.material.userData.surface = worn.join(', ');
    writeSurfaceMaps(code, surface.uniforms, this.uniforms, maps, this.textures, () => {
      if (this.users > 0) this.refresh();
    });
  }

  /** Writes a simulated value of a surface field, such as 'surface.height'. */
  write(name: string, value: FieldValue): void {
    const target = targetsOf(this.asset.surfaceFields).get(name);
    const uniform = target && this.uniforms[target.uniform];
    if (!uniform) return;
    if (typeof value === 'number' && target.axis !== null)
      (uniform.value as unknown as Vector3)[target.axis as 'x'] = value;
    else if (typeof value === 'number' || typeof value === 'boolean') uniform.value = value;
    else if (Array.isArray(value)) {
      const [x, y, z] = value as readonly number[];
      if (uniform.value instanceof Color) uniform.value.setRGB(x, y, z);
      else (uniform.value as Vector3).set(x, y, z);
    }
  }

  dispose(): void {
    this.source.removeEventListener('dispose', this.sourceDisposed);
    this.material.dispose();
  }

  // frees the material's programs with those of the source; the next draw compiles them again
  private readonly sourceDisposed = (): void => this.material.dispose();
}
