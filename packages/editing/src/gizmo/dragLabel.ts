import { toDegrees } from '../fields/angles';
import { namesOf } from '../labels';
import { t } from '../language/translate';
import type { TransformDrag, TransformMode } from './TransformDrag';

const short = (value: number): string => String(Number(value.toFixed(3)) + 0);

/**
 * Label of a drag in the history: 'Moved Lantern 3 by 0, 1.2, 0 m', 'Rotated 3 objects by 45°'.
 * @param objects - dragged objects; at least one
 */
export function dragLabel(
  mode: TransformMode,
  objects: readonly { readonly name: string; readonly type?: string }[],
  drag: TransformDrag,
): string {
  const name = namesOf(objects);
  if (mode === 'rotate') return t('Rotated {name} by {angle}°', { name, angle: short(toDegrees(drag.angle)) });
  const [x, y, z] = (mode === 'translate' ? drag.offset : drag.factors).toArray().map(short);
  if (mode === 'translate') return t('Moved {name} by {x}, {y}, {z} m', { name, x, y, z });
  if (x === y && y === z) return t('Scaled {name} by {factor}', { name, factor: x });
  return t('Scaled {name} by {x}, {y}, {z}', { name, x, y, z });
}
