import type { Field, FieldValue, Vector3Tuple } from '@farol/editing/fields';
import type { Color, Euler, Vector3 } from 'three';
import type { Property } from './Property';

type Target = Record<string, unknown>;

/**
 * Declares a field for the property of that name on a three object: assigned directly for numbers, texts and flags,
 * copied in and out for vectors, Euler angles and colours.
 * @param after - called with the object once the value is set
 */
export function declare(name: string, field: Field, after?: (target: Target) => void): Property<Target> {
  const { get, set } = accessOf(field, name);
  return {
    ...{ name, field, get },
    set(target, value) {
      set(target, value);
      after?.(target);
    },
  };
}

function accessOf(field: Field, name: string): Pick<Property<Target>, 'get' | 'set'> {
  switch (field.kind) {
    case 'vector3':
      return {
        get: (target) => {
          const { x, y, z } = target[name] as Vector3;
          return [x, y, z];
        },
        set: (target, value) => void (target[name] as Vector3).fromArray([...(value as Vector3Tuple)]),
      };
    case 'euler':
      return {
        get: (target) => {
          const { x, y, z } = target[name] as Euler;
          return [x, y, z];
        },
        set: (target, value) => void (target[name] as Euler).set(...(value as [number, number, number])),
      };
    case 'colour':
      return {
        get: (target) => {
          const { r, g, b } = target[name] as Color;
          return [r, g, b];
        },
        set: (target, value) => void (target[name] as Color).fromArray([...(value as Vector3Tuple)]),
      };
    default:
      return {
        get: (target) => target[name] as FieldValue,
        set: (target, value) => void (target[name] = value),
      };
  }
}

/** Declares a choice among three's constants, displayed by name. @param values - constants by name */
export function declareConstant(
  name: string,
  help: string,
  values: Readonly<Record<string, unknown>>,
  after?: (target: Target) => void,
): Property<Target> {
  const options = Object.keys(values);
  return {
    name,
    field: { kind: 'choice', default: options[0], options, help },
    get: (target) => options.find((option) => values[option] === target[name]) ?? options[0],
    set(target, value) {
      target[name] = values[value as string];
      after?.(target);
    },
  };
}
