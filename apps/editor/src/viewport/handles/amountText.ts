import { t, toDegrees } from '@farol/editing';
import type { TransformMode } from '@farol/editing';

/** As many decimals as can be read while something moves. */
const digitsOf = (value: number): number => (Math.abs(value) < 0.1 && Math.abs(value) >= 0.0005 ? 3 : 2);

const signed = (value: number): string => {
  const text = Math.abs(value).toFixed(digitsOf(value));
  return `${value < 0 && Number(text) !== 0 ? '−' : '+'}${text}`;
};

/** An amount of a drag as it is shown beside the handle: '+1.20 m', '+45°', '×1.50'. @param value - m, rad or a factor */
export function amountText(mode: TransformMode, value: number): string {
  if (mode === 'translate') return t('{amount} m', { amount: signed(value) });
  if (mode === 'scale') return `×${value.toFixed(digitsOf(value))}`;
  const degrees = Number(toDegrees(value).toFixed(1)) + 0;
  return `${degrees < 0 ? '−' : '+'}${Math.abs(degrees)}°`;
}

/** What stands before and after a number that is typed. */
export function amountSigns(mode: TransformMode): readonly [before: string, after: string] {
  if (mode === 'translate') return ['', ` ${t('m')}`];
  return mode === 'rotate' ? ['', '°'] : ['×', ''];
}
