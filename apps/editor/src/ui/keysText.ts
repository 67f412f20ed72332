import { tCount } from '@farol/editing';
import type { Curve, Gradient } from '@farol/engine/fields';

/** Summary of a curve or gradient, such as '3 keys'. */
export const keysText = (keys: Curve | Gradient): string => tCount(keys.length, '{count} key', '{count} keys');
