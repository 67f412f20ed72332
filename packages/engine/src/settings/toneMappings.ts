import {
  ACESFilmicToneMapping,
  AgXToneMapping,
  CineonToneMapping,
  LinearToneMapping,
  NeutralToneMapping,
  NoToneMapping,
  ReinhardToneMapping,
  type ToneMapping,
} from 'three';

/** three's tone mappings, by their names in files. */
export const toneMappings = {
  none: NoToneMapping,
  linear: LinearToneMapping,
  reinhard: ReinhardToneMapping,
  cineon: CineonToneMapping,
  'aces-filmic': ACESFilmicToneMapping,
  agx: AgXToneMapping,
  neutral: NeutralToneMapping,
} as const satisfies Record<string, ToneMapping>;

export const toneMappingLabels = {
  none: 'None',
  linear: 'Linear',
  reinhard: 'Reinhard',
  cineon: 'Cineon',
  'aces-filmic': 'ACES filmic',
  agx: 'AgX',
  neutral: 'Neutral',
} as const;

export type ToneMappingName = keyof typeof toneMappings;

export const toneMappingNames = Object.keys(toneMappings) as ToneMappingName[];
