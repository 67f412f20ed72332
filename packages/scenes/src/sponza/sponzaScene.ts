import { boolean, choice, number } from '@farol/editing/fields';
import { defineScene } from '../SceneDefinition';
import { seedField } from '../seedField';

export const sponzaScene = defineScene({
  name: 'sponza',
  label: 'Sponza',
  help: 'An atrium with two storeys of arcades, of the scale of the Sponza palace.',
  parameters: {
    lights: number(50, { integer: true, min: 0, max: 20000, help: 'Moving point lights.' }),
    textureSize: choice('256', ['128', '256', '512'], {
      help: 'Width of the generated textures in texels.',
      label: 'Texture size',
    }),
    shadows: number(0, {
      integer: true,
      min: 0,
      max: 20000,
      help: 'How many of the lights cast shadows (six faces of 512 texels each).',
    }),
    sunShadow: boolean(false, { help: 'Whether the sun casts shadows.', label: 'Sun casts shadows' }),
    still: boolean(false, {
      help: 'The lights stand still, so that their shadow maps are kept.',
      label: 'Lights at rest',
    }),
    seed: seedField,
  },
  sample: { shadows: 2, sunShadow: true },
  make: async (get, assets) => {
    const { sponza } = await import('./sponza');
    return sponza(get('lights') as number, {
      textureSize: Number(get('textureSize')) as 128 | 256 | 512,
      shadowLights: get('shadows') as number,
      shadows: get('sunShadow') as boolean,
      still: get('still') as boolean,
      seed: get('seed') as number,
      assets,
    });
  },
});
