import { asset, number } from '@farol/editing/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';
import { shadowsField } from '../shadowsField';

export const benchmarkLightsObjectsScene = defineScene({
  name: 'benchmarkLightsObjects',
  label: 'Meshes and lights',
  help: 'N × N meshes with M × M moving lights above them, or grids that are no squares.',
  parameters: {
    n: number(10, { integer: true, min: 1, max: 100, help: 'Meshes from left to right.', label: 'Meshes (N)' }),
    nRows: number(0, {
      integer: true,
      min: 0,
      max: 100,
      help: 'Meshes from front to back; 0: as many as N.',
      label: 'Meshes in depth',
    }),
    m: number(10, { integer: true, min: 0, max: 150, help: 'Lights from left to right.', label: 'Lights (M)' }),
    mRows: number(0, {
      integer: true,
      min: 0,
      max: 150,
      help: 'Lights from front to back; 0: as many as M.',
      label: 'Lights in depth',
    }),
    mesh: asset('mesh', 'sphere', { help: 'The mesh.' }),
    shadows: shadowsField,
    seed: seedField,
  },
  sample: { shadows: true },
  make: async (get, assets) => {
    const { benchmarkLightsObjects } = await import('./benchmarkLightsObjects');
    return benchmarkLightsObjects(get('n') as number, get('m') as number, (get('mesh') as string | null) ?? 'sphere', {
      shadows: get('shadows') as boolean,
      nRows: (get('nRows') as number) || undefined,
      mRows: (get('mRows') as number) || undefined,
      seed: get('seed') as number,
      assets,
    });
  },
});
