import { type FieldEdit, SetFields, t } from '@farol/editing';
import type { Light } from '@farol/engine';
import { Vector3 } from 'three';
import { alongLine, type Handle, roundTo } from '../handles/HandlePoints';

/** Smallest size of a light (m). */
const SMALLEST = 0.01;

const metres = (value: number): string => t('{amount} m', { amount: String(Number(value.toFixed(3))) });

/**
 * Handles on the edges of a rectangle, disc or tube light, which keep its centre in place. A round disc stays round; an
 * ellipse grows along the dragged axis. Other lights have none.
 */
export function areaLightHandles(light: Light): Handle[] {
  const { type, width, height, gameObject } = light;
  if (!light.isArea) return [];
  const { object3D } = gameObject;
  object3D.updateWorldMatrix(true, false);
  const centre = new Vector3().setFromMatrixPosition(object3D.matrixWorld);
  const isRound = type === 'disc' && width === height;
  const handles: Handle[] = [];
  const sides = [
    { column: 0, name: 'width', size: width },
    { column: 1, name: 'height', size: height },
  ] as const;
  for (const { column, name, size } of sides) {
    const axis = new Vector3().setFromMatrixColumn(object3D.matrixWorld, column).normalize();
    if (axis.lengthSq() === 0) continue; // an object scaled to 0 has no such axis
    for (const sense of [1, -1]) {
      const direction = axis.clone().multiplyScalar(sense);
      handles.push({
        place: centre.clone().addScaledVector(direction, size / 2),
        drag(ray, step) {
          const reach = alongLine(centre, direction, ray);
          if (reach === null) return null;
          const value = Math.max(roundTo(2 * reach, step), SMALLEST);
          const names = isRound ? ['width', 'height'] : [name];
          const edits = names.map((each): FieldEdit => ({ owner: light, name: each, value }));
          return new SetFields(t('Sized {name}', { name: gameObject.name }), edits);
        },
        textOf([{ value }]) {
          if (isRound) return `${t('Radius')} ${metres((value as number) / 2)}`;
          if (type === 'tube') return `${name === 'width' ? t('Length') : t('Thickness')} ${metres(value as number)}`;
          return `${name === 'width' ? t('Width') : t('Height')} ${metres(value as number)}`;
        },
      });
    }
  }
  return handles;
}
