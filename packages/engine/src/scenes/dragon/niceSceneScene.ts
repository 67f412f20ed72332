import { number } from '../../fields/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';

export const niceSceneScene = defineScene({
  name: 'niceScene',
  label: 'Nice scene',
  help: 'A dragon, a sphere and a cylinder in a room with all three kinds of lights.',
  parameters: {
    lights: number(0, { integer: true, min: 0, max: 20000, help: 'Moving point lights besides the three.' }),
    seed: seedField,
  },
  make: async (get, assets) => {
    const { niceScene } = await import('./niceScene');
    return niceScene({ lights: get('lights') as number, seed: get('seed') as number, assets });
  },
});
