import { number } from '@farol/editing/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';
import { shadowsField } from '../shadowsField';

export const dragonsScene = defineScene({
  name: 'dragons',
  label: 'Dragons',
  help: 'Four dragons among coloured lights.',
  parameters: {
    lights: number(24, { integer: true, min: 0, max: 20000, help: 'Moving point lights.' }),
    shadows: shadowsField,
    seed: seedField,
  },
  sample: { shadows: true },
  make: async (get, assets) => {
    const { dragons } = await import('./dragons');
    return dragons({
      lights: get('lights') as number,
      shadows: get('shadows') as boolean,
      seed: get('seed') as number,
      assets,
    });
  },
});
