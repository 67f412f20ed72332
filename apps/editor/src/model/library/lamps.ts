import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';
import type { libraryNames } from './names';
import { DOWN, glow, type ItemRoot, light, mesh, type Part, type Place } from './parts';

type Values = Readonly<Record<string, FieldValue>>;

/** Colours of lamps, by temperature (K). */
const [FIRE, WARM, WHITE, DAY] = [1900, 2700, 3500, 6500].map((kelvin): Values => ({
  colourBy: 'temperature',
  kelvin,
}));

const softShadow = { castShadow: true, shadowMapSize: 512, shadowRadius: 3 };

/** A light whose field `type` is `point`. @param intensity - cd @param range - m */
const bulb = (colour: Values, intensity: number, range: number, place: Place): Part =>
  light({ ...colour, intensity, range }, place);

/** A cone of light with soft shadows. @param intensity - cd @param range - m @param cutoff - rad */
const spot = (colour: Values, intensity: number, range: number, cutoff: number, place: Place): Part =>
  light({ type: 'spot', ...softShadow, ...colour, intensity, range, cutoff, penumbra: 0.6 }, place);

const chandelierArms = (count: number): Part[] =>
  Array.from({ length: count }, (_, i): Part => {
    const turn: Vector3Tuple = [0, (i * 2 * Math.PI) / count, 0];
    const parts = [
      mesh('Arm', 'cylinder', 'Brass', { at: [0.24, -0.78, 0], turn: [0, 0, Math.PI / 2], size: [0.018, 0.48, 0.018] }),
      mesh('Candle', 'cylinder', 'Wax', { at: [0.47, -0.71, 0], size: [0.03, 0.12, 0.03] }),
      glow('Flame', 'sphere', 'Flame', { at: [0.47, -0.62, 0], size: [0.025, 0.06, 0.025] }),
      bulb(WARM, 1.6, 6, { at: [0.47, -0.6, 0] }),
    ];
    return { name: 'Arm', turn, parts };
  });

/** Bulbs on a string of 4 m that sags by 0.5 m. */
const stringOfBulbs = (count: number): Part[] =>
  Array.from({ length: count }, (_, i): Part => {
    const x = -2 + (4 * (i + 0.5)) / count;
    const y = 0.5 * ((x / 2) ** 2 - 1);
    const parts = [glow('Bulb', 'sphere', 'Warm glow', { size: [0.06, 0.08, 0.06] }), bulb(WARM, 0.35, 2.5, {})];
    return { name: 'Bulb', at: [x, y - 0.06, -0.06], parts };
  });

/** Straight pieces between the points of the string. */
const stringPieces = (count: number): Part[] =>
  Array.from({ length: count }, (_, i): Part => {
    const height = (x: number): number => 0.5 * ((x / 2) ** 2 - 1);
    const [from, to] = [-2 + (4 * i) / count, -2 + (4 * (i + 1)) / count];
    const slope = Math.atan2(height(to) - height(from), to - from);
    const length = Math.hypot(to - from, height(to) - height(from));
    return mesh('String', 'cylinder', 'Rubber', {
      at: [(from + to) / 2, (height(from) + height(to)) / 2, -0.06],
      turn: [0, 0, slope + Math.PI / 2],
      size: [0.008, length, 0.008],
    });
  });

/** Root of each lamp. Lamps tagged `ceiling` hang from their origin; lamps tagged `wall` touch the wall there. */
export const lamps: Readonly<Record<keyof typeof libraryNames.lamp, () => ItemRoot>> = {
  'street-lamp': () => ({
    parts: [
      mesh('Foot', 'cylinder', 'Cast iron', { at: [0, 0.2, 0], size: [0.34, 0.4, 0.34] }),
      mesh('Post', 'cylinder', 'Cast iron', { at: [0, 2.1, 0], size: [0.11, 3.8, 0.11] }),
      mesh('Collar', 'sphere', 'Cast iron', { at: [0, 4, 0], size: [0.2, 0.12, 0.2] }),
      mesh('Hat', 'cone', 'Cast iron', { at: [0, 4.62, 0], size: [0.62, 0.28, 0.62] }),
      glow('Glass', 'cylinder', 'Warm glow', { at: [0, 4.26, 0], size: [0.3, 0.44, 0.3] }),
      spot(WARM, 90, 12, 1.2, { at: [0, 4.4, 0], turn: DOWN }),
    ],
  }),
  lantern: () => ({
    parts: [
      mesh('Base', 'cylinder', 'Copper', { at: [0, 0.02, 0], size: [0.2, 0.04, 0.2] }),
      mesh('Glass', 'cylinder', 'Glass', { at: [0, 0.15, 0], size: [0.16, 0.22, 0.16] }, { castShadow: false }),
      glow('Flame', 'sphere', 'Flame', { at: [0, 0.12, 0], size: [0.035, 0.09, 0.035] }),
      mesh('Hat', 'cone', 'Copper', { at: [0, 0.31, 0], size: [0.22, 0.1, 0.22] }, { castShadow: false }),
      mesh('Ring', 'torus', 'Copper', { at: [0, 0.4, 0], size: [0.12, 0.12, 0.05] }, { castShadow: false }),
      bulb(FIRE, 4, 6, { at: [0, 0.15, 0] }),
    ],
  }),
  torch: () => ({
    tags: ['wall'],
    parts: [
      mesh('Plate', 'box', 'Cast iron', { at: [0, -0.1, -0.015], size: [0.1, 0.24, 0.03] }),
      mesh('Handle', 'cylinder', 'Bark', { at: [0, 0.02, -0.13], turn: [-0.4, 0, 0], size: [0.05, 0.5, 0.05] }),
      mesh('Bowl', 'cone', 'Cast iron', { at: [0, 0.27, -0.24], turn: [Math.PI, 0, 0], size: [0.16, 0.14, 0.16] }),
      glow('Flame', 'cone', 'Flame', { at: [0, 0.45, -0.24], size: [0.11, 0.26, 0.11] }),
      bulb(FIRE, 8, 9, { at: [0, 0.5, -0.3] }),
    ],
  }),
  candle: () => ({
    parts: [
      mesh('Plate', 'cylinder', 'Brass', { at: [0, 0.008, 0], size: [0.14, 0.016, 0.14] }),
      mesh('Candle', 'cylinder', 'Wax', { at: [0, 0.09, 0], size: [0.05, 0.15, 0.05] }, { castShadow: false }),
      glow('Flame', 'sphere', 'Flame', { at: [0, 0.19, 0], size: [0.02, 0.055, 0.02] }),
      bulb(FIRE, 1, 4, { at: [0, 0.21, 0] }),
    ],
  }),
  pendant: () => ({
    tags: ['ceiling'],
    parts: [
      mesh('Rose', 'cylinder', 'Enamel', { at: [0, -0.015, 0], size: [0.12, 0.03, 0.12] }),
      mesh('Cable', 'cylinder', 'Rubber', { at: [0, -0.42, 0], size: [0.012, 0.8, 0.012] }),
      mesh('Shade', 'cone', 'Enamel', { at: [0, -0.88, 0], size: [0.44, 0.24, 0.44] }),
      glow('Bulb', 'sphere', 'Warm glow', { at: [0, -1.01, 0], size: [0.1, 0.1, 0.1] }),
      spot(WARM, 40, 8, 1.3, { at: [0, -1.02, 0], turn: DOWN }),
    ],
  }),
  'desk-lamp': () => ({
    parts: [
      mesh('Foot', 'cylinder', 'Cast iron', { at: [0, 0.012, 0], size: [0.18, 0.024, 0.18] }),
      mesh('Lower arm', 'cylinder', 'Steel', { at: [0, 0.18, 0.06], turn: [0.38, 0, 0], size: [0.016, 0.34, 0.016] }),
      mesh('Upper arm', 'cylinder', 'Steel', { at: [0, 0.42, 0.04], turn: [-0.9, 0, 0], size: [0.016, 0.3, 0.016] }),
      mesh('Shade', 'cone', 'Enamel', { at: [0, 0.48, -0.12], turn: [0.35, 0, 0], size: [0.18, 0.15, 0.18] }),
      glow('Bulb', 'sphere', 'White glow', { at: [0, 0.42, -0.145], size: [0.06, 0.06, 0.06] }),
      spot(WHITE, 10, 3, 0.9, { at: [0, 0.42, -0.15], turn: [-Math.PI / 2 + 0.35, 0, 0] }),
    ],
  }),
  'neon-tube': () => ({
    tags: ['wall'],
    parts: [
      mesh('Holder', 'box', 'Steel', { at: [-0.5, 0, -0.03], size: [0.03, 0.04, 0.06] }),
      mesh('Holder', 'box', 'Steel', { at: [0.5, 0, -0.03], size: [0.03, 0.04, 0.06] }),
      glow('Tube', 'cylinder', 'Red glow', {
        ...{ at: [0, 0, -0.07], turn: [0, 0, Math.PI / 2], size: [0.03, 1.2, 0.03] },
      }),
      light(
        { type: 'tube', diffuse: [1, 0.08, 0.08], intensity: 120, width: 1.2, height: 0.03, areaRange: 6 },
        { at: [0, 0, -0.08] },
      ),
    ],
  }),
  panel: () => ({
    tags: ['ceiling'],
    parts: [
      mesh('Casing', 'box', 'Enamel', { at: [0, -0.02, 0], size: [0.64, 0.04, 0.64] }),
      glow('Diffuser', 'box', 'White glow', { at: [0, -0.041, 0], size: [0.6, 0.004, 0.6] }),
      light(
        { type: 'rectangle', ...WHITE, intensity: 30, width: 0.6, height: 0.6, areaRange: 8 },
        { at: [0, -0.045, 0], turn: DOWN },
      ),
    ],
  }),
  'rail-spots': () => ({
    tags: ['ceiling'],
    parts: [
      mesh('Rail', 'box', 'Steel', { at: [0, -0.02, 0], size: [1.4, 0.03, 0.03] }),
      ...[-0.5, 0, 0.5].map((x, i): Part => ({
        name: 'Spot',
        at: [x, -0.14, 0],
        turn: [0.5, 0, (i - 1) * 0.35],
        parts: [
          mesh('Can', 'cylinder', 'Cast iron', { size: [0.09, 0.18, 0.09] }, { castShadow: false }),
          glow('Lens', 'cylinder', 'White glow', { at: [0, -0.091, 0], size: [0.07, 0.004, 0.07] }),
          spot(WHITE, 35, 8, 0.4, { at: [0, -0.1, 0], turn: DOWN }),
        ],
      })),
    ],
  }),
  chandelier: () => ({
    tags: ['ceiling'],
    parts: [
      mesh('Rose', 'cylinder', 'Brass', { at: [0, -0.02, 0], size: [0.16, 0.04, 0.16] }),
      mesh('Chain', 'cylinder', 'Brass', { at: [0, -0.4, 0], size: [0.02, 0.75, 0.02] }),
      mesh('Ball', 'sphere', 'Brass', { at: [0, -0.8, 0], size: [0.16, 0.2, 0.16] }),
      ...chandelierArms(8),
    ],
  }),
  'fairy-lights': () => ({
    tags: ['wall'],
    parts: [...stringPieces(8), ...stringOfBulbs(12)],
  }),
  sconce: () => ({
    tags: ['wall'],
    parts: [
      mesh('Plate', 'box', 'Brass', { at: [0, 0, -0.012], size: [0.11, 0.2, 0.024] }),
      mesh('Arm', 'cylinder', 'Brass', { at: [0, -0.04, -0.07], turn: [Math.PI / 2, 0, 0], size: [0.02, 0.12, 0.02] }),
      glow('Shade', 'cylinder', 'Warm glow', { at: [0, 0.06, -0.13], size: [0.14, 0.2, 0.14] }),
      bulb(WARM, 3, 6, { at: [0, 0.08, -0.2] }),
    ],
  }),
  floodlight: () => ({
    parts: [
      ...[0, 1, 2].map((i): Part => ({
        name: 'Leg',
        turn: [0, (i * 2 * Math.PI) / 3, 0],
        parts: [
          mesh('Leg', 'cylinder', 'Cast iron', {
            ...{ at: [0, 0.36, 0.22], turn: [-0.55, 0, 0], size: [0.03, 0.85, 0.03] },
          }),
        ],
      })),
      mesh('Post', 'cylinder', 'Steel', { at: [0, 1.2, 0], size: [0.035, 1.1, 0.035] }),
      {
        name: 'Head',
        at: [0, 1.85, 0],
        turn: [-0.15, 0, 0],
        parts: [
          mesh('Housing', 'box', 'Cast iron', { at: [0, 0, 0.05], size: [0.42, 0.3, 0.12] }, { castShadow: false }),
          glow('Lens', 'box', 'White glow', { at: [0, 0, -0.012], size: [0.38, 0.26, 0.004] }),
          spot(WHITE, 400, 25, 0.75, { at: [0, 0, -0.02] }),
        ],
      },
    ],
  }),
  headlamps: () => ({
    parts: [
      mesh('Bumper', 'box', 'Chrome', { at: [0, 0.42, 0.05], size: [1.6, 0.14, 0.12] }),
      ...[-0.6, 0.6].map((x): Part => ({
        name: 'Headlamp',
        at: [x, 0.65, 0],
        turn: [-0.05, 0, 0],
        parts: [
          mesh('Cup', 'cylinder', 'Chrome', {
            ...{ at: [0, 0, 0.08], turn: [Math.PI / 2, 0, 0], size: [0.22, 0.14, 0.22] },
          }),
          glow('Lens', 'cylinder', 'White glow', {
            ...{ at: [0, 0, 0.005], turn: [Math.PI / 2, 0, 0], size: [0.18, 0.01, 0.18] },
          }),
          spot(WHITE, 600, 40, 0.3, { at: [0, 0, -0.01] }),
        ],
      })),
    ],
  }),
  'daylight-window': () => ({
    tags: ['wall'],
    parts: [
      ...[-0.6, 0.6].map((x) => mesh('Casing', 'box', 'Enamel', { at: [x, 0, -0.03], size: [0.08, 1.36, 0.06] })),
      ...[-0.64, 0.64].map((y) => mesh('Casing', 'box', 'Enamel', { at: [0, y, -0.03], size: [1.28, 0.08, 0.06] })),
      mesh('Bar', 'box', 'Enamel', { at: [0, 0, -0.03], size: [0.04, 1.28, 0.04] }),
      mesh('Bar', 'box', 'Enamel', { at: [0, 0.2, -0.03], size: [1.2, 0.04, 0.04] }),
      glow('Pane', 'box', 'Daylight glow', { at: [0, 0, -0.008], size: [1.2, 1.28, 0.01] }),
      light(
        { type: 'rectangle', ...DAY, intensity: 14, width: 1.2, height: 1.28, areaRange: 12 },
        { at: [0, 0, -0.07] },
      ),
    ],
  }),
};
