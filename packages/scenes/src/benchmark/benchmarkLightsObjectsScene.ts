import { asset, number } from '@farol/editing/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';
import { shadowsField } from '../shadowsField';

export const benchmarkLightsObjectsScene = defineScene({
  name: 'benchmarkLightsObjects',
  label: 'Meshes and lights',
  help: 'N × N meshes with M × M moving lights above them.',
  parameters: {
    n: number(10, { integer: true, min: 1, max: 100, help: 'Meshes along a side.', label: 'Meshes (N)' }),
    m: number(10, { integer: true, min: 0, max: 150, help: 'Lights along a side.', label: 'Lights (M)' }),
    mesh: asset('mesh', 'sphere', { help: 'The mesh.' }),
    shadows: shadowsField,
    seed: seedField,
  },
  sample: { shadows: true },
  make: async (get, assets) => {
    const { benchmarkLightsObjects } = await import('./benchmarkLightsObjects');
    return benchmarkLightsObjects(get('n') as number, get('m') as number, (get('mesh') as string | null) ?? 'sphere', {
      shadows: get('shadows') as boolean,
      seed: get('seed') as number,
      assets,
    });
  },
});
