import { number } from '@farol/editing/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';
import { shadowsField } from '../shadowsField';

export const benchmarkLightsScene = defineScene({
  name: 'benchmarkLights',
  label: 'Planes and lights',
  help: 'N × N planes with M × M moving lights above them, or grids that are no squares.',
  parameters: {
    n: number(5, { integer: true, min: 1, max: 100, help: 'Planes from left to right.', label: 'Planes (N)' }),
    nRows: number(0, {
      integer: true,
      min: 0,
      max: 100,
      help: 'Planes from front to back; 0: as many as N.',
      label: 'Planes in depth',
    }),
    m: number(15, { integer: true, min: 0, max: 150, help: 'Lights from left to right.', label: 'Lights (M)' }),
    mRows: number(0, {
      integer: true,
      min: 0,
      max: 150,
      help: 'Lights from front to back; 0: as many as M.',
      label: 'Lights in depth',
    }),
    shadows: shadowsField,
    seed: seedField,
  },
  sample: { shadows: true },
  make: async (get, assets) => {
    const { benchmarkLights } = await import('./benchmarkLights');
    return benchmarkLights(get('n') as number, get('m') as number, {
      shadows: get('shadows') as boolean,
      nRows: (get('nRows') as number) || undefined,
      mRows: (get('mRows') as number) || undefined,
      seed: get('seed') as number,
      assets,
    });
  },
});
