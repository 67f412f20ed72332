import type { Vector3Tuple } from '@farol/editing/fields';
import type { BufferGeometry } from 'three';
import { createRandom } from '@farol/engine';
import { MeshBuilder, type Profile } from '@farol/engine/builders';

/** A curtain of 2.2 m × 3.4 m in folds, hanging from y = 0; two sheets back to back, so that nothing is double sided. */
export function curtainMesh(): BufferGeometry {
  const builder = new MeshBuilder();
  const [width, height] = [2.2, 3.4];
  for (const face of [1, -1]) {
    const sheet = (u: number, v: number): Vector3Tuple => {
      const across = face > 0 ? u : 1 - u;
      const drop = 1 - v;
      const fold = Math.sin(across * 5 * 2 * Math.PI + Math.sin(drop * 2.2) * 0.9);
      const gather = 1 - 0.22 * Math.sin(Math.PI * Math.min(1, drop * 1.25)) ** 2;
      const z = (0.05 + 0.13 * drop) * fold + 0.012 * face;
      return [width * (across - 0.5) * gather, -height * drop - 0.08 * Math.sin(Math.PI * across), z];
    };
    builder.surface(44, 16, sheet, [2, 3]);
  }
  return builder.build(1.2);
}

const urnOutside: Profile = (v) => {
  const belly = 0.16 + 0.36 * Math.sin(Math.PI * Math.min(1, v * 0.92 + 0.02)) ** 1.3 * (0.55 + 0.45 * v);
  const lip = v > 0.9 ? (v - 0.9) * 1.6 : 0;
  return [belly + lip, 0.18 + 0.92 * v];
};

const urnInside: Profile = (v) => {
  const [radius, y] = urnOutside(1);
  return [radius * (1 - v * 0.9), y - 0.12 * v];
};

/** An urn of 1.1 m on a foot. */
export function urnMesh(): BufferGeometry {
  return new MeshBuilder()
    .box([-0.32, 0, -0.32], [0.32, 0.1, 0.32])
    .lathe(32, 4, (v) => [0.28 - 0.1 * v, 0.1 + 0.08 * v], [2, 0.2])
    .lathe(32, 18, urnOutside, [2, 1])
    .lathe(32, 4, urnInside, [2, 0.4])
    .build(0.7);
}

/** A plant of long bent leaves, about 1.1 m high, growing from y = 0. */
export function plantMesh(): BufferGeometry {
  const builder = new MeshBuilder();
  const random = createRandom(17);
  for (let leaf = 0; leaf < 26; leaf++) {
    const angle = leaf * 2.4 + random();
    const bend = 0.25 + 0.75 * (leaf / 26);
    const long = 0.75 + 0.5 * random();
    builder.at(0, 0, 0, angle);
    for (const face of [1, -1]) {
      const blade = (u: number, v: number): Vector3Tuple => {
        const side = (face > 0 ? u : 1 - u) - 0.5;
        const width = 0.1 * Math.sin(Math.PI * Math.min(1, v * 0.92 + 0.08)) ** 0.7;
        const out = long * bend * v * (0.5 + 0.5 * v);
        const up = long * (v - bend * 0.62 * v ** 2.2);
        return [side * width * 2, up + Math.abs(side) * 0.05, out + 0.003 * face];
      };
      builder.surface(2, 7, blade, [0.2, 1]);
    }
  }
  return builder.build(1);
}

const bowl: Profile = (v) => [0.02 + 0.3 * Math.sin((v * Math.PI) / 1.7) ** 0.8, -1.55 + 0.35 * v];

/** A hanging lamp: chain of 1.2 m down from y = 0, and a bowl. */
export function lampMesh(): BufferGeometry {
  return new MeshBuilder()
    .lathe(8, 1, (v) => [0.018, -1.2 + 1.2 * v], [0.1, 1.2])
    .lathe(32, 10, bowl, [2, 0.5])
    .lathe(32, 4, (v) => [0.31 - 0.28 * v, -1.2 + 0.05 * v], [2, 0.3])
    .build(0.7);
}
