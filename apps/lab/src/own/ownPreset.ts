import type { Configuration } from '../plan/Configuration';
import { presets, type Preset } from '../plan/presets';

/** Whether a configuration measures the scene that another app has handed over. */
export const usesOwnScene = ({ series }: Configuration): boolean => series.some(({ scene }) => scene === 'own');

/** Preset that measures the handed-over scene by all competitors. @param name - name of the scene */
export function ownPreset(name: string): Preset {
  const { configuration } = presets.quick;
  return {
    label: name,
    help: 'Your scene with its own lights, in small and large pictures.',
    configuration: {
      ...configuration,
      preset: 'custom',
      series: [{ scene: 'own', n: 1, axis: 'pixels', values: [230, 922, 2074], lights: 0 }],
    },
  };
}
