import { number } from '@farol/editing/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';
import { shadowsField } from '../shadowsField';

export const niceSceneScene = defineScene({
  name: 'niceScene',
  label: 'Nice scene',
  help: 'A dragon, a sphere and a cylinder in a room with all three kinds of lights.',
  parameters: {
    lights: number(0, { integer: true, min: 0, max: 20000, help: 'Moving point lights besides the three.' }),
    shadows: shadowsField,
    seed: seedField,
  },
  sample: { shadows: true },
  make: async (get, assets) => {
    const { niceScene } = await import('./niceScene');
    return niceScene({
      lights: get('lights') as number,
      shadows: get('shadows') as boolean,
      seed: get('seed') as number,
      assets,
    });
  },
});
