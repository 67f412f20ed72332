import {
  asset,
  boolean,
  colour,
  type Field,
  type FieldTable,
  type FieldValue,
  number,
  string,
  vector3,
  type Vector3Tuple,
} from '@farol/editing/fields';
import type { SurfaceUniform, SurfaceValues } from '@farol/renderer/surfaces';

/** Prefix of field names for uniforms of a surface. */
export const UNIFORM = 'surface.';
/** Fields of a material that hold the textures of a surface, in the order in which it declares them. */
export const surfaceMaps = ['surfaceMap1', 'surfaceMap2', 'surfaceMap3', 'surfaceMap4'] as const;

/** A condition that is never met: the inspector hides these fields, and shows those of the surface's uniforms. */
const hidden = { visibleWhen: { field: 'surface', equals: [] } };
const map = asset('texture', null, { ...hidden, help: 'A texture of the surface.', label: 'Surface texture' });

/** Fields that store a surface's uniform values, for owners with a field `surface`. */
export const surfaceValueFields = {
  /** JSON of uniform values that differ from the surface's defaults, by uniform name. */
  surfaceValues: string('', { ...hidden, help: 'Values of the surface.', readOnly: true }),
  surfaceMap1: map,
  surfaceMap2: map,
  surfaceMap3: map,
  surfaceMap4: map,
};

const AXES = ['x', 'y', 'z', 'w'];

/**
 * Fields for the uniforms that a surface declares. Values are stored in the material's `surfaceValues`, textures in
 * `surfaceMap1` to `surfaceMap4`. A vec2 or vec4 gets a field for each component; a fifth texture gets none.
 */
export function uniformFieldsOf(uniforms: readonly SurfaceUniform[]): FieldTable {
  const fields: Record<string, Field> = {};
  let textures = 0;
  for (const uniform of uniforms) {
    const { name, type, label, default: value, min, max, step } = uniform;
    const shared = { label, help: '', viewOf: 'surfaceValues' };
    const range = {
      ...(min !== undefined && { min }),
      ...(max !== undefined && { max }),
      ...(step !== undefined ? { step } : min !== undefined && type !== 'int' && { step: stepOf(min, max!) }),
    };
    const key = UNIFORM + name;
    if (type === 'sampler2D') {
      const map = surfaceMaps[textures++];
      if (map) fields[key] = asset('texture', null, { ...shared, viewOf: map });
    } else if (type === 'bool') fields[key] = boolean(value as boolean, shared);
    else if (type === 'float') fields[key] = number(value as number, { ...shared, ...range });
    else if (type === 'int') fields[key] = number(value as number, { ...shared, ...range, integer: true, step: 1 });
    else if (type === 'vec3' && uniform.isColor) fields[key] = colour(triple(value), shared);
    else if (type === 'vec3') fields[key] = vector3(triple(value), { ...shared, ...range });
    else {
      (value as readonly number[]).forEach((part, i) => {
        fields[`${key}.${AXES[i]}`] = number(part, { ...shared, ...range, label: `${label} ${AXES[i].toUpperCase()}` });
      });
    }
  }
  return fields;
}

/** Step of an arrow key: about a hundredth of a range. */
const stepOf = (least: number, most: number): number => 10 ** Math.round(Math.log10((most - least) / 100));

const triple = (value: SurfaceUniform['default']): Vector3Tuple => {
  const [x, y, z] = value as readonly number[];
  return [x, y, z];
};

/** Values of a surface's uniforms, but for textures. @param get - reads a field by its name */
export function uniformValues(uniforms: readonly SurfaceUniform[], get: (name: string) => FieldValue): SurfaceValues {
  const values: Record<string, SurfaceValues[string]> = {};
  for (const { name, type } of uniforms) {
    if (type === 'sampler2D') continue;
    const size = type === 'vec2' ? 2 : type === 'vec4' ? 4 : 0;
    values[name] =
      size > 0
        ? AXES.slice(0, size).map((axis) => get(`${UNIFORM}${name}.${axis}`) as number)
        : (get(UNIFORM + name) as number | boolean | Vector3Tuple);
  }
  return values;
}
