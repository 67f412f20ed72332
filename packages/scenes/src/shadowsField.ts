import { boolean } from '@farol/editing/fields';

/** The switch for shadows of a scene. */
export const shadowsField = boolean(false, {
  help: 'Meshes throw and receive shadows, in suns, spot lights and a few point lights.',
});
