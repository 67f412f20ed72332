import {
  BoxGeometry,
  ConeGeometry,
  CylinderGeometry,
  IcosahedronGeometry,
  PlaneGeometry,
  SphereGeometry,
  TorusGeometry,
} from 'three';
import { builtinTextures } from '../textures/builtinTextures';
import type { AssetSource } from './Asset';
import { builtinProfiles } from '../profiles/builtinProfiles';

const mesh = (make: () => ReturnType<Extract<AssetSource, { make: unknown }>['make']>): AssetSource => ({
  type: 'mesh',
  make,
});

/** The assets that every library knows. Meshes are 1 m in size, centred on the origin unless said otherwise. */
export const builtinAssets: Readonly<Record<string, AssetSource>> = {
  box: mesh(() => new BoxGeometry()),
  sphere: mesh(() => new SphereGeometry(0.5, 48, 24)),
  /** Square in the xz plane that faces up (+Y). */
  plane: mesh(() => new PlaneGeometry().rotateX(-Math.PI / 2)),
  /** The plane with 64 × 64 squares, for surfaces that move vertices. */
  grid: mesh(() => new PlaneGeometry(1, 1, 64, 64).rotateX(-Math.PI / 2)),
  cylinder: mesh(() => new CylinderGeometry(0.5, 0.5, 1, 48)),
  cone: mesh(() => new ConeGeometry(0.5, 1, 48)),
  torus: mesh(() => new TorusGeometry(0.35, 0.15, 24, 64)),
  /** A ball of 12 cm and 80 triangles, to show where lamps are. */
  bulb: mesh(() => new IcosahedronGeometry(0.06, 1)),
  /** A dragon, 1 m long, standing on y = 0. */
  dragon: { type: 'mesh', load: async () => (await import('../geometry/dragon/dragonMesh')).dragonMesh() },
  ...builtinTextures,
  ...builtinProfiles,
};
