import shadowBounds from './shadowBounds.glsl?raw';
import tilePlane from './tilePlane.glsl?raw';
import tileShadows from './tileShadows.glsl?raw';

export { ShadowBounds } from './ShadowBounds';
export { ShadowTiles } from './ShadowTiles';
export const tileMicroShaders = { shadowBounds, tilePlane, tileShadows };
