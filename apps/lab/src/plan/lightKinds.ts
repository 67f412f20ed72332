/** Texts of a kind of lights or of a shading. */
export interface LightKindWords {
  readonly label: string;
  readonly help: string;
  /** Name within a text and beside an axis: `with rectangles`, `1,000 rectangles`. */
  readonly word: string;
}

/** Kinds of moving lights by key: all have the places, ranges and brightness of the scene's point lights. */
export const lightKinds = {
  points: { label: 'Point lights', word: 'points', help: 'PointLights of three.js.' },
  spots: { label: 'Spot lights', word: 'spots', help: 'SpotLights of three.js that shine down, with soft edges.' },
  rectangles: {
    label: 'Rectangles',
    word: 'rectangles',
    help: 'RectAreaLights of 40 cm × 25 cm that shine down; those of Farol end where the points do.',
  },
  profiles: {
    label: 'Profiles',
    word: 'points with profiles',
    help: 'Point lights shaped by three photometric profiles: downlight, wall washer, street light.',
  },
  field: {
    label: 'LightField',
    word: 'a LightField',
    help: 'Point lights as data of one object; all of them move, so all are sent in each frame.',
  },
  particles: {
    label: 'Particles',
    word: 'particles',
    help: 'Each particle that the GPU moves is a light. The particles are drawn too.',
  },
} as const satisfies Record<string, LightKindWords>;

export type LightKind = keyof typeof lightKinds;

/** Keys in the order of the axis. Runs store indices, so new kinds are added at the end. */
export const lightKindNames = Object.keys(lightKinds) as readonly LightKind[];

/** Kinds with an object per light; the others are data of one object. */
export type SingleLightKind = Exclude<LightKind, 'field' | 'particles'>;

export const isSingleLightKind = (kind: LightKind): kind is SingleLightKind => kind !== 'field' && kind !== 'particles';

export const shadings = {
  own: { label: 'As they are', word: 'the materials’ own shading', help: 'Materials as the scene has them.' },
  flat: { label: 'Flat', word: 'flat shading', help: 'One normal a triangle.' },
  gouraud: { label: 'Gouraud', word: 'Gouraud shading', help: 'Lit at the vertices, by forward draws.' },
  phong: { label: 'Phong', word: 'Phong shading', help: 'Lit in each pixel, by interpolated normals.' },
} as const satisfies Record<string, LightKindWords>;

export type Shading = keyof typeof shadings;

/** Keys in the order of the axis; new shadings are added at the end. */
export const shadingNames = Object.keys(shadings) as readonly Shading[];
