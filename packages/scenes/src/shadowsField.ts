import { boolean } from '@farol/editing/fields';

/** Field of a scene's switch for shadows. */
export const shadowsField = boolean(false, {
  help: 'Meshes throw and receive shadows, in suns, spot lights and a few point lights.',
});
