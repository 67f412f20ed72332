/** What the moving lights of a case are. */
export interface LightKindWords {
  /** In menus. */
  readonly label: string;
  readonly help: string;
  /** In sentences and beside an axis: `with rectangles`, `1,000 rectangles`. */
  readonly word: string;
}

/** Kinds of the moving lights, by key; all shine where the point lights of the scene do, as far and as brightly. */
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

/** In the order of the axis: the place of a kind is its value there, in runs that were kept too. New ones come last. */
export const lightKindNames = Object.keys(lightKinds) as readonly LightKind[];

/** Kinds whose lights are objects of their own; the others are data of one object. */
export type SingleLightKind = Exclude<LightKind, 'field' | 'particles'>;

export const isSingleLightKind = (kind: LightKind): kind is SingleLightKind => kind !== 'field' && kind !== 'particles';

/** How the materials of a case are shaded. */
export const shadings = {
  own: { label: 'As they are', word: 'the materials’ own shading', help: 'Materials as the scene has them.' },
  flat: { label: 'Flat', word: 'flat shading', help: 'One normal a triangle.' },
  gouraud: { label: 'Gouraud', word: 'Gouraud shading', help: 'Lit at the vertices, by forward draws.' },
  phong: { label: 'Phong', word: 'Phong shading', help: 'Lit in each pixel, by interpolated normals.' },
} as const satisfies Record<string, LightKindWords>;

export type Shading = keyof typeof shadings;

/** In the order of the axis, as for the kinds of lights. */
export const shadingNames = Object.keys(shadings) as readonly Shading[];
