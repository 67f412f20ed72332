import type { Vector3Tuple } from '@farol/engine/fields';
import type { libraryNames } from './names';
import { type ItemRoot, mesh, type Part, solid } from './parts';

/** A ball of leaves. @param at - centre (m) @param width - diameter (m) */
const leaves = (at: Vector3Tuple, width: number): Part =>
  mesh('Leaves', 'sphere', 'Leaves', { at, size: [width, width * 0.8, width] });

/** Boards beside each other along an axis. @param step - offset from each board to the next (m) */
const boards = (count: number, from: Vector3Tuple, step: Vector3Tuple, size: Vector3Tuple): Part[] =>
  Array.from({ length: count }, (_, i) =>
    mesh('Board', 'box', 'Wood', { at: [from[0] + i * step[0], from[1] + i * step[1], from[2] + i * step[2]], size }),
  );

const legs = (x: number, z: number, height: number, width: number): Part[] =>
  [-1, 1].flatMap((sx) =>
    [-1, 1].map((sz) => mesh('Leg', 'box', 'Wood', { at: [sx * x, height / 2, sz * z], size: [width, height, width] })),
  );

/** Root of each prop. */
export const props: Readonly<Record<keyof typeof libraryNames.prop, () => ItemRoot>> = {
  street: () => ({
    parts: [
      solid(mesh('Road', 'box', 'Asphalt', { at: [0, 0.01, 0], size: [40, 0.04, 6] })),
      ...[-1, 1].map((side) =>
        solid(mesh('Pavement', 'box', 'Paving', { at: [0, 0.075, side * 4.5], size: [40, 0.15, 3] })),
      ),
      ...Array.from({ length: 10 }, (_, i) =>
        mesh('Line', 'box', 'Enamel', { at: [-18 + i * 4, 0.031, 0], size: [1.6, 0.004, 0.12] }, { castShadow: false }),
      ),
    ],
  }),
  tree: () => ({
    parts: [
      solid(mesh('Trunk', 'cylinder', 'Bark', { at: [0, 1, 0], size: [0.28, 2, 0.28] }), 'cylinder'),
      mesh('Branch', 'cylinder', 'Bark', { at: [0.25, 2, 0.1], turn: [0.2, 0, -0.6], size: [0.14, 1, 0.14] }),
      leaves([0, 3.2, 0], 2.4),
      leaves([0.75, 2.7, 0.3], 1.6),
      leaves([-0.7, 2.75, -0.2], 1.7),
      leaves([0.1, 2.6, -0.8], 1.5),
    ],
  }),
  fir: () => ({
    parts: [
      mesh('Trunk', 'cylinder', 'Bark', { at: [0, 0.4, 0], size: [0.22, 0.8, 0.22] }),
      ...[0, 1, 2, 3].map((i) =>
        mesh('Needles', 'cone', 'Needles', {
          ...{ at: [0, 1.3 + i * 0.8, 0], turn: [0, i, 0], size: [2.2 - i * 0.45, 1.4, 2.2 - i * 0.45] },
        }),
      ),
    ],
  }),
  bench: () => ({
    parts: [
      ...boards(4, [0, 0.45, -0.17], [0, 0, 0.11], [1.6, 0.04, 0.09]),
      ...boards(3, [0, 0.6, 0.21], [0, 0.12, 0.025], [1.6, 0.09, 0.03]),
      ...[-0.65, 0.65].flatMap((x) => [
        mesh('Foot', 'box', 'Cast iron', { at: [x, 0.21, 0], size: [0.05, 0.42, 0.4] }),
        mesh('Backrest', 'box', 'Cast iron', { at: [x, 0.68, 0.25], turn: [0.2, 0, 0], size: [0.05, 0.5, 0.04] }),
      ]),
    ],
  }),
  table: () => ({
    parts: [
      solid(mesh('Top', 'box', 'Wood', { at: [0, 0.73, 0], size: [1.4, 0.04, 0.8] })),
      ...legs(0.62, 0.32, 0.71, 0.06),
    ],
  }),
  chair: () => ({
    parts: [
      mesh('Seat', 'box', 'Wood', { at: [0, 0.44, 0], size: [0.42, 0.04, 0.42] }),
      ...legs(0.18, 0.18, 0.42, 0.04),
      ...boards(3, [0, 0.6, 0.195], [0, 0.14, 0], [0.42, 0.07, 0.03]),
      ...[-0.19, 0.19].map((x) => mesh('Post', 'box', 'Wood', { at: [x, 0.69, 0.195], size: [0.04, 0.5, 0.03] })),
    ],
  }),
  crate: () => ({
    parts: [
      solid(mesh('Box', 'box', 'Wood', { at: [0, 0.4, 0], size: [0.76, 0.76, 0.76] })),
      ...[-1, 1].flatMap((x) =>
        [-1, 1].map((z) => mesh('Edge', 'box', 'Wood', { at: [x * 0.37, 0.4, z * 0.37], size: [0.08, 0.8, 0.08] })),
      ),
      ...[0.03, 0.77].flatMap((y) => [
        ...[-1, 1].map((z) => mesh('Edge', 'box', 'Wood', { at: [0, y, z * 0.38], size: [0.74, 0.06, 0.06] })),
        ...[-1, 1].map((x) => mesh('Edge', 'box', 'Wood', { at: [x * 0.38, y, 0], size: [0.06, 0.06, 0.74] })),
      ]),
    ],
  }),
  barrel: () => ({
    parts: [
      solid(mesh('Barrel', 'cylinder', 'Wood', { at: [0, 0.45, 0], size: [0.58, 0.9, 0.58] }), 'cylinder'),
      ...[0.12, 0.35, 0.55, 0.78].map((y) =>
        mesh('Hoop', 'cylinder', 'Cast iron', { at: [0, y, 0], size: [0.6, 0.05, 0.6] }),
      ),
    ],
  }),
  'plain-wall': () => ({
    components: [
      ['Wall', { length: 4, height: 2.8, thickness: 0.2, opening: 'none' }],
      ['ObjectRenderer', { mesh: null, castShadow: true, receiveShadow: true, material: 'Plaster' }],
      ['Collider', { shape: 'mesh' }],
    ],
  }),
  fence: () => ({
    parts: [
      ...boards(13, [-1.2, 0.5, 0], [0.2, 0, 0], [0.09, 1, 0.02]),
      ...[0.25, 0.75].map((y) => mesh('Rail', 'box', 'Wood', { at: [0, y, 0.03], size: [2.6, 0.07, 0.04] })),
    ],
  }),
  column: () => ({
    parts: [
      mesh('Base', 'box', 'Marble', { at: [0, 0.1, 0], size: [0.7, 0.2, 0.7] }),
      mesh('Ring', 'cylinder', 'Marble', { at: [0, 0.25, 0], size: [0.62, 0.1, 0.62] }),
      solid(mesh('Shaft', 'cylinder', 'Marble', { at: [0, 1.75, 0], size: [0.5, 2.9, 0.5] }), 'cylinder'),
      mesh('Ring', 'cylinder', 'Marble', { at: [0, 3.23, 0], size: [0.62, 0.08, 0.62] }),
      mesh('Capital', 'box', 'Marble', { at: [0, 3.37, 0], size: [0.74, 0.2, 0.74] }),
    ],
  }),
  steps: () => ({
    parts: [0, 1, 2, 3].map((i) =>
      solid(
        mesh('Step', 'box', 'Stone', { at: [0, 0.085 * (i + 1), 0.45 - 0.3 * i], size: [1.6, 0.17 * (i + 1), 0.3] }),
      ),
    ),
  }),
  ground: () => ({
    size: [40, 1, 40],
    components: [
      ['ObjectRenderer', { mesh: 'plane', material: 'Grass', receiveShadow: true }],
      // 1 m thick, so that nothing falls through
      ['Collider', { fit: false, size: [1, 1, 1], offset: [0, -0.5, 0] }],
    ],
  }),
};
