import { t } from '@farol/editing';
import type { Curve } from '@farol/engine/fields';

export interface CurvePreset {
  readonly id: string;
  readonly label: string;
  readonly curve: Curve;
}

/** Samples a smooth function densely enough that linear pieces look smooth. @param course - value by time (0 to 1) */
const smooth = (course: (time: number) => number): Curve =>
  Array.from({ length: 13 }, (_, i) => [Number((i / 12).toFixed(4)), Number(course(i / 12).toFixed(4))] as const);

const smoothstep = (time: number): number => time * time * (3 - 2 * time);

/** Preset curves between a lowest and a highest value. */
export function curvePresets(low: number, high: number): readonly CurvePreset[] {
  const between = (curve: Curve): Curve =>
    curve.map(([time, value]) => [time, Number((low + (high - low) * value).toPrecision(6))] as const);
  const preset = (id: string, label: string, curve: Curve): CurvePreset => ({ id, label, curve: between(curve) });
  return [
    preset('constant', t('Constant'), [[0, 1]]),
    preset('rise', t('Linear rise'), straight(0, 1)),
    preset('fade', t('Linear fade'), straight(1, 0)),
    preset(
      'ease-in',
      t('Ease in'),
      smooth((time) => time * time),
    ),
    preset(
      'ease-out',
      t('Ease out'),
      smooth((time) => (1 - time) * (1 - time)),
    ),
    preset('ease', t('Ease in and out'), smooth(smoothstep)),
    preset(
      'bell',
      t('Bell'),
      smooth((time) => Math.sin(Math.PI * time) ** 2),
    ),
    preset('plateau', t('In, stay, out'), [
      [0, 0],
      [0.15, 1],
      [0.7, 1],
      [1, 0],
    ]),
  ];
}

const straight = (from: number, to: number): Curve => [
  [0, from],
  [1, to],
];
