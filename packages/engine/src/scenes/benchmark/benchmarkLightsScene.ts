import { number } from '../../fields/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';

export const benchmarkLightsScene = defineScene({
  name: 'benchmarkLights',
  label: 'Planes and lights',
  help: 'N × N planes with M × M moving lights above them.',
  parameters: {
    n: number(5, { integer: true, min: 1, max: 100, help: 'Planes along a side.', label: 'Planes (N)' }),
    m: number(15, { integer: true, min: 0, max: 150, help: 'Lights along a side.', label: 'Lights (M)' }),
    seed: seedField,
  },
  make: async (get, assets) => {
    const { benchmarkLights } = await import('./benchmarkLights');
    return benchmarkLights(get('n') as number, get('m') as number, { seed: get('seed') as number, assets });
  },
});
