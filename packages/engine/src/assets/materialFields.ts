import { angle, asset, boolean, choice, colour, number, type ValuesOf } from '@farol/editing/fields';
import type { Blending } from 'three';

const made = { visibleWhen: { field: 'material', equals: [null] } };
const lit = { visibleWhen: { field: 'kind', equals: ['standard', 'physical', 'phong', 'lambert'] } };
const pbr = { visibleWhen: { field: 'kind', equals: ['standard', 'physical'] } };
const phong = { visibleWhen: { field: 'kind', equals: ['phong'] } };
const physical = { visibleWhen: { field: 'kind', equals: ['physical'] } };

/** The kinds of material that an ObjectRenderer makes: three's MeshStandardMaterial and so on. */
export const materialKinds = ['standard', 'phong', 'lambert', 'basic', 'physical'] as const;

/** The fields of an ObjectRenderer that describe its material. */
export const materialFields = {
  kind: choice('standard', materialKinds, { help: 'Shading model of the surface.', ...made }),
  colour: colour([0.8, 0.8, 0.8], { help: 'Diffuse colour; multiplies the map.', ...made }),
  map: asset('texture', null, { help: 'Texture of the colour.', ...made }),
  normalMap: asset('texture', null, { help: 'Texture of bumps, in tangent space.', label: 'Normal map', ...lit }),
  normalScale: number(1, {
    step: 0.05,
    help: 'Strength of the bumps; below 0 they are inverted.',
    label: 'Bump strength',
    ...lit,
  }),
  repeat: number(1, { min: 0.001, max: 10000, help: 'How many times textures repeat over the mesh.', ...made }),
  shading: choice('smooth', ['smooth', 'gouraud', 'flat'], {
    help: 'Phong: normals are interpolated. Gouraud: light is evaluated at the vertices. Flat: one normal for each triangle.',
    optionLabels: { smooth: 'Phong', gouraud: 'Gouraud', flat: 'Flat' },
    ...lit,
  }),
  roughness: number(0.6, { min: 0, max: 1, step: 0.01, help: '0 is a mirror, 1 is chalk.', ...pbr }),
  metalness: number(0, { min: 0, max: 1, step: 0.01, help: '0 for insulators, 1 for metals.', ...pbr }),
  ambient: colour([1, 1, 1], { help: 'Factor of the colour under ambient light; white is as in three.', ...phong }),
  specular: colour([0.07, 0.07, 0.07], { help: 'Colour of the highlight.', ...phong }),
  shininess: number(40, { min: 0, max: 10000, help: 'Exponent of the highlight: larger is smaller.', ...phong }),
  clearcoat: number(0, { min: 0, max: 1, step: 0.01, help: 'Layer of varnish.', ...physical }),
  clearcoatRoughness: number(0, {
    min: 0,
    max: 1,
    step: 0.01,
    help: 'Roughness of the varnish.',
    label: 'Clearcoat roughness',
    ...physical,
  }),
  transmission: number(0, {
    min: 0,
    max: 1,
    step: 0.01,
    help: 'How far light passes through, as through glass.',
    ...physical,
  }),
  ior: number(1.5, { min: 1, max: 2.333, step: 0.01, help: 'Index of refraction.', ...physical }),
  emissive: colour([0, 0, 0], { help: 'Light that the surface gives off by itself.', ...lit }),
  emissiveIntensity: number(1, {
    min: 0,
    step: 0.1,
    help: 'Factor of the emission.',
    label: 'Emissive intensity',
    ...lit,
  }),
  transparent: boolean(false, { help: 'Mix with what lies behind, by the opacity.', ...made }),
  opacity: number(1, {
    min: 0,
    max: 1,
    step: 0.01,
    help: '0 is invisible, 1 hides what lies behind.',
    visibleWhen: { field: 'transparent', equals: [true] },
  }),
  alphaTest: number(0, {
    min: 0,
    max: 1,
    step: 0.01,
    help: 'Texels with less alpha are left out.',
    label: 'Alpha test',
    ...made,
  }),
  doubleSided: boolean(false, { help: 'Draw the backs of triangles too.', label: 'Double sided', ...made }),
  wireframe: boolean(false, { help: 'Draw the edges of triangles only.', ...made }),
  vertexColours: boolean(false, { help: 'Multiply by the colours of the vertices.', label: 'Vertex colours', ...made }),
};

/** Values of `materialFields`, with properties of a material that no field of an ObjectRenderer holds. */
export type MaterialValues = Readonly<ValuesOf<typeof materialFields>> & {
  /** Blending as three's constant. Default NormalBlending. */
  readonly blending?: Blending;
};

/** Smallest angle between faces that shows as an edge, for meshes without normals. */
export const creaseAngleField = angle(Math.PI / 6, {
  min: 0,
  max: Math.PI,
  help: 'For meshes without normals: faces that meet at less are smooth, at more they show an edge.',
  label: 'Crease angle',
});

/** `materialFields` as a group of an ObjectRenderer. */
export const ownMaterialFields = Object.fromEntries(
  Object.entries(materialFields).map(([name, field]) => [name, { ...field, group: 'Own material' }]),
) as unknown as typeof materialFields;
