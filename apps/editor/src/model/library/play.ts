import type { libraryNames } from './names';
import { glow, type ItemRoot, light, mesh, type Part, type PartComponent, solid } from './parts';

/** An EventTrigger that the player sets off, and that calls a method. @param target - name of a part */
const playerTrigger = (event: string, target: string | null, method: string): PartComponent => [
  'EventTrigger',
  { event, otherTag: 'player', ...(target !== null && { target: `part:${target}` }), ...(method && { method }) },
];

/** A sensor collider: a box that reports objects that enter and leave. Size in m. */
const sensor = (width: number, height: number, depth: number): PartComponent => [
  'Collider',
  { fit: false, size: [width, height, depth], offset: [0, height / 2, 0], sensor: true },
];

/** A small lamp that hovers. */
const orb: readonly Part[] = [
  glow('Ball', 'sphere', 'Warm glow', { size: [0.12, 0.12, 0.12] }),
  light({ colourBy: 'temperature', kelvin: 2700, intensity: 6, range: 8 }),
];

/** Root of each item that does something while the scene plays. */
export const play: Readonly<Record<keyof typeof libraryNames.play, () => ItemRoot>> = {
  player: () => ({
    tags: ['player'],
    components: [['CharacterController', {}]],
    parts: [
      {
        name: 'Eyes',
        at: [0, 1.65, 0],
        components: [
          ['Camera', {}],
          ['AudioListener', {}],
        ],
      },
    ],
  }),
  door: () => ({
    parts: [
      ...[-0.48, 0.48].map((x) =>
        solid(mesh('Casing', 'box', 'Enamel', { at: [x, 1.04, 0], size: [0.06, 2.08, 0.18] })),
      ),
      mesh('Casing', 'box', 'Enamel', { at: [0, 2.11, 0], size: [1.02, 0.06, 0.18] }),
      {
        name: 'Hinge',
        at: [-0.44, 0, 0],
        components: [
          ['RigidBody', { type: 'kinematic' }],
          ['Door', {}],
        ],
        parts: [
          solid(mesh('Leaf', 'box', 'Wood', { at: [0.44, 1.04, 0], size: [0.87, 2.06, 0.05] })),
          ...[-1, 1].map((side) =>
            mesh('Handle', 'sphere', 'Brass', { at: [0.8, 1.02, side * 0.06], size: [0.07, 0.07, 0.07] }),
          ),
        ],
      },
      {
        name: 'Threshold',
        components: [
          sensor(2.4, 2.2, 4),
          playerTrigger('triggerEnter', 'Hinge', 'Door.open'),
          playerTrigger('triggerExit', 'Hinge', 'Door.close'),
        ],
      },
    ],
  }),
  zone: () => ({ components: [sensor(2, 2, 2), playerTrigger('triggerEnter', null, '')] }),
  flicker: () => ({ components: [['Flicker', {}]], at: [0, 1, 0], parts: orb }),
  follow: () => ({ components: [['Follow', {}]], parts: orb }),
  patrol: () => ({
    parts: [
      {
        name: 'Guard',
        components: [['Patrol', { way: 'part:Way' }]],
        parts: [
          mesh('Body', 'cylinder', 'Steel', { at: [0, 0.7, 0], size: [0.4, 1.4, 0.4] }),
          mesh('Head', 'sphere', 'Steel', { at: [0, 1.55, 0], size: [0.3, 0.34, 0.3] }),
          glow('Lens', 'sphere', 'White glow', { at: [0, 1.2, -0.2], size: [0.1, 0.1, 0.06] }),
          light(
            {
              type: 'spot',
              intensity: 60,
              range: 14,
              cutoff: 0.5,
              penumbra: 0.6,
              castShadow: true,
              shadowMapSize: 512,
            },
            { at: [0, 1.2, -0.24], turn: [-0.25, 0, 0] },
          ),
        ],
      },
      {
        name: 'Way',
        parts: (
          [
            [2, -2],
            [2, 2],
            [-2, 2],
            [-2, -2],
          ] as const
        ).map(([x, z]) => ({ name: 'Point', at: [x, 0, z] })),
      },
    ],
  }),
};
