import { LightField } from '@farol/renderer/light-field';
import { type PointLight, Vector3 } from 'three';
import type { LightPaths } from './LightPaths';

/** Number of lights that can be added while the scene is measured. */
const SPARE = 10;

/** The lights of a case as one LightField. */
export interface MovingField {
  readonly field: LightField;
  /** Moves all lights to their places at a time (s). */
  place(paths: LightPaths, seconds: number): void;
  /** Adds a light; at most 10. */
  add(light: PointLight): void;
  /** Removes the last lights. */
  remove(count: number): void;
}

const position = new Vector3();

/** Creates the LightField. @param lights - point lights whose colour, intensity, range and decay are copied */
export function movingField(lights: readonly PointLight[]): MovingField {
  const field = new LightField(lights.length + SPARE);
  field.count = 0;
  const add = ({ position: { x, y, z }, distance, color, intensity, decay }: PointLight): void => {
    const [r, g, b] = [color.r * intensity, color.g * intensity, color.b * intensity];
    field.setPoint(field.count++, x, y, z, distance, r, g, b, decay);
  };
  lights.forEach(add);
  const { array } = field.spheres;
  return {
    field,
    place(paths, seconds) {
      for (let i = 0; i < field.count; i++) {
        paths.place(i, seconds, position);
        array[i * 4] = position.x;
        array[i * 4 + 1] = position.y;
        array[i * 4 + 2] = position.z;
      }
      field.spheres.update(0, field.count);
    },
    add,
    remove: (count) => void (field.count -= count),
  };
}
