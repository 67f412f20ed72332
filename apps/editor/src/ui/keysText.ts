import { tCount } from '@farol/editing';
import type { Curve, Gradient } from '@farol/engine/fields';

/** A curve or a gradient in words. */
export const keysText = (keys: Curve | Gradient): string => tCount(keys.length, '{count} key', '{count} keys');
