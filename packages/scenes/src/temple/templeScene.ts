import { boolean, number } from '@farol/editing/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';
import { shadowsField } from '../shadowsField';

export const templeScene = defineScene({
  name: 'temple',
  label: 'Temple',
  help: 'A temple of columns on a green plane, with moving lights.',
  parameters: {
    lights: number(50, { integer: true, min: 0, max: 20000, help: 'Moving point lights.' }),
    shadows: shadowsField,
    evening: boolean(false, {
      help: 'A low sun that casts shadows, a sky at sunset and tone mapping, in place of even light.',
    }),
    seed: seedField,
  },
  sample: { shadows: true, evening: true },
  make: async (get, assets) => {
    const { temple } = await import('./temple');
    return temple(get('lights') as number, {
      shadows: get('shadows') as boolean,
      evening: get('evening') as boolean,
      seed: get('seed') as number,
      assets,
    });
  },
});
