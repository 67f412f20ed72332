import { number } from '@farol/editing/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';
import { shadowsField } from '../shadowsField';

export const benchmarkLightsScene = defineScene({
  name: 'benchmarkLights',
  label: 'Planes and lights',
  help: 'N × N planes with M × M moving lights above them.',
  parameters: {
    n: number(5, { integer: true, min: 1, max: 100, help: 'Planes along a side.', label: 'Planes (N)' }),
    m: number(15, { integer: true, min: 0, max: 150, help: 'Lights along a side.', label: 'Lights (M)' }),
    shadows: shadowsField,
    seed: seedField,
  },
  sample: { shadows: true },
  make: async (get, assets) => {
    const { benchmarkLights } = await import('./benchmarkLights');
    return benchmarkLights(get('n') as number, get('m') as number, {
      shadows: get('shadows') as boolean,
      seed: get('seed') as number,
      assets,
    });
  },
});
