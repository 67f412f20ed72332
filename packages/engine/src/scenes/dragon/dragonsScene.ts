import { number } from '../../fields/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';

export const dragonsScene = defineScene({
  name: 'dragons',
  label: 'Dragons',
  help: 'Four Stanford dragons among coloured lights.',
  parameters: {
    lights: number(24, { integer: true, min: 0, max: 20000, help: 'Moving point lights.' }),
    seed: seedField,
  },
  make: async (get, assets) => {
    const { dragons } = await import('./dragons');
    return dragons({ lights: get('lights') as number, seed: get('seed') as number, assets });
  },
});
