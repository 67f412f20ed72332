import { t, toDegrees } from '@farol/editing';
import type { TransformMode } from '@farol/editing';

/** Number of decimals, few enough to be readable while the value changes. */
const digitsOf = (value: number): number => (Math.abs(value) < 0.1 && Math.abs(value) >= 0.0005 ? 3 : 2);

const signed = (value: number): string => {
  const text = Math.abs(value).toFixed(digitsOf(value));
  return `${value < 0 && Number(text) !== 0 ? '−' : '+'}${text}`;
};

/** Amount of a drag for the readout: '+1.20 m', '+45°', '×1.50'. @param value - m, rad or a factor */
export function amountText(mode: TransformMode, value: number): string {
  if (mode === 'translate') return t('{amount} m', { amount: signed(value) });
  if (mode === 'scale') return `×${value.toFixed(digitsOf(value))}`;
  const degrees = Number(toDegrees(value).toFixed(1)) + 0;
  return `${degrees < 0 ? '−' : '+'}${Math.abs(degrees)}°`;
}

/** Text before and after a typed number, such as its unit. */
export function amountSigns(mode: TransformMode): readonly [before: string, after: string] {
  if (mode === 'translate') return ['', ` ${t('m')}`];
  return mode === 'rotate' ? ['', '°'] : ['×', ''];
}
