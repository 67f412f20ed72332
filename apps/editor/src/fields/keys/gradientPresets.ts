import { joinColour, t } from '@farol/editing';
import { type Gradient, joinKeys } from '@farol/engine/fields';

export interface GradientPreset {
  readonly id: string;
  readonly label: string;
  readonly gradient: Gradient;
}

type Stops = readonly (readonly [time: number, hex: string, intensity?: number])[];
type Opacities = readonly (readonly [time: number, opacity: number])[];

const made = (colours: Stops, opacities: Opacities): Gradient =>
  joinKeys(
    colours.map(([time, hex, intensity = 1]) => [time, joinColour(hex, intensity)!] as const),
    opacities,
  );

const OUT: Opacities = [
  [0, 1],
  [1, 0],
];
const IN_AND_OUT: Opacities = [
  [0, 0],
  [0.15, 1],
  [0.7, 1],
  [1, 0],
];

/** Preset gradients, with labels in the user's language. */
export const gradientPresets = (): readonly GradientPreset[] => [
  { id: 'white', label: t('White'), gradient: made([[0, '#ffffff']], [[0, 1]]) },
  { id: 'out', label: t('White, fading out'), gradient: made([[0, '#ffffff']], OUT) },
  { id: 'in-out', label: t('White, in and out'), gradient: made([[0, '#ffffff']], IN_AND_OUT) },
  {
    id: 'fire',
    label: t('Fire##colours'),
    gradient: made(
      [
        [0, '#fff1c2', 2],
        [0.3, '#ff9a2e', 1.5],
        [0.65, '#d8330a'],
        [1, '#2a0d06'],
      ],
      [
        [0, 0],
        [0.1, 1],
        [0.6, 0.7],
        [1, 0],
      ],
    ),
  },
  {
    id: 'smoke',
    label: t('Smoke##colours'),
    gradient: made(
      [
        [0, '#4a4744'],
        [1, '#a3a3a6'],
      ],
      [
        [0, 0],
        [0.2, 0.35],
        [1, 0],
      ],
    ),
  },
  {
    id: 'embers',
    label: t('Embers'),
    gradient: made(
      [
        [0, '#ffd27a', 3],
        [0.5, '#ff6a1a', 2],
        [1, '#7a1603'],
      ],
      [
        [0, 1],
        [0.8, 1],
        [1, 0],
      ],
    ),
  },
  {
    id: 'sky',
    label: t('Cold light'),
    gradient: made(
      [
        [0, '#ffffff'],
        [0.4, '#8fd6ff', 1.5],
        [1, '#1f4bff'],
      ],
      OUT,
    ),
  },
  {
    id: 'rainbow',
    label: t('Rainbow'),
    gradient: made(
      ['#ff0000', '#ffff00', '#00ff00', '#00ffff', '#0000ff', '#ff00ff', '#ff0000'].map(
        (hex, i) => [Number((i / 6).toFixed(3)), hex] as const,
      ),
      [[0, 1]],
    ),
  },
];
