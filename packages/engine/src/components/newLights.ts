import type { NewObject } from '../core/NewObject';
import { lightShadows, sunShadows } from './newShadows';

/** Rotation to point down, as lights shine along -Z. */
const down = [-Math.PI / 2, 0, 0] as const;

/** New lights by type, with values that make them noticeable among others. */
const lights: Readonly<Record<string, Pick<NewObject, 'rotation' | 'values'>>> = {
  ambient: { values: { intensity: 0.3 } },
  hemisphere: { values: { intensity: 0.6 } },
  directional: { values: { intensity: 1.5, ...sunShadows(50) }, rotation: [-0.9, 0.6, 0] },
  point: { values: { intensity: 12, range: 10, ...lightShadows.point } },
  spot: { values: { intensity: 30, range: 15, ...lightShadows.spot }, rotation: down },
  rectangle: { values: { intensity: 12, width: 1, height: 1 }, rotation: down },
  disc: { values: { intensity: 12, width: 1, height: 1 }, rotation: down },
  tube: { values: { intensity: 60, width: 1.2, height: 0.04 } },
};

/** Entries for lights in the Add menu. */
export const newLights: readonly NewObject[] = Object.entries(lights).map(([type, { values, rotation }]) => ({
  label: `${type.charAt(0).toUpperCase()}${type.slice(1)} light`,
  group: 'light',
  icon: type,
  values: { type, ...values },
  rotation,
}));
