import { angle, asset, boolean, choice, colour, type FieldTable, number } from '@farol/editing/fields';
import { materialFields, materialKinds } from './materialFields';
import { fieldsOfMap, materialMapNames } from './materialMaps';
import { surfaceValueFields } from './uniformFields';

const lit = { visibleWhen: { field: 'kind', equals: ['standard', 'physical', 'phong', 'lambert'] } };
const physical = { visibleWhen: { field: 'kind', equals: ['physical'] } };
const part = { min: 0, max: 1, step: 0.01 };

/** Fields shared with an ObjectRenderer's own material, without the condition that no material asset is set. */
function sharedFields(): FieldTable {
  const { kind, map: _map, normalMap: _normalMap, repeat: _repeat, ...others } = materialFields;
  return Object.fromEntries([
    ['kind', { ...kind, options: materialKinds, visibleWhen: undefined }],
    ...Object.entries(others).map(([name, field]) => {
      const isOwn = field.visibleWhen?.field === 'material';
      return [name, isOwn ? { ...field, visibleWhen: undefined } : field];
    }),
  ]) as FieldTable;
}

/** Fields of a MaterialAsset: all properties of three's mesh materials. */
export const materialAssetFields: FieldTable = {
  ...sharedFields(),
  normalFlip: boolean(false, { help: 'Green points down, as in maps made for DirectX.', label: 'Flip green', ...lit }),
  bumpScale: number(1, { step: 0.05, help: 'Strength of the bump map.', label: 'Bump height', ...lit }),
  displacementScale: number(1, {
    unit: 'm',
    step: 0.01,
    help: 'How far white moves a vertex outwards.',
    label: 'Displacement',
    ...lit,
  }),
  displacementBias: number(0, {
    unit: 'm',
    step: 0.01,
    help: 'How far black moves a vertex outwards.',
    label: 'Bias',
    ...lit,
  }),
  aoIntensity: number(1, { ...part, help: 'Strength of the occlusion map.', label: 'Occlusion' }),
  lightMapIntensity: number(1, { min: 0, step: 0.05, help: 'Factor of the light map.', label: 'Light strength' }),
  clearcoatNormalScale: number(1, {
    step: 0.05,
    help: 'Strength of the normals of the clearcoat.',
    label: 'Coat strength',
    ...physical,
  }),
  clearcoatNormalFlip: boolean(false, {
    help: 'Green points down, as in maps made for DirectX.',
    label: 'Coat flip green',
    ...physical,
  }),
  sheen: number(0, { ...part, help: 'Soft light at grazing angles, as of velvet.', ...physical }),
  sheenColour: colour([1, 1, 1], { help: 'Colour of the sheen.', label: 'Sheen colour', ...physical }),
  sheenRoughness: number(1, { ...part, help: 'Roughness of the sheen.', label: 'Sheen roughness', ...physical }),
  iridescence: number(0, { ...part, help: 'Colours of a thin film, as of a soap bubble.', ...physical }),
  iridescenceIor: number(1.3, {
    min: 1,
    max: 2.333,
    step: 0.01,
    help: 'Index of refraction of the film.',
    label: 'Film index',
    ...physical,
  }),
  iridescenceThicknessMin: number(100, {
    unit: 'nm',
    min: 0,
    step: 10,
    help: 'Thickness of the film where its map is black.',
    label: 'Least thickness',
    ...physical,
  }),
  iridescenceThicknessMax: number(400, {
    unit: 'nm',
    min: 0,
    step: 10,
    help: 'Thickness of the film where its map is white, or there is none.',
    label: 'Film thickness',
    ...physical,
  }),
  anisotropy: number(0, { ...part, help: 'Stretches highlights, as of brushed metal.', ...physical }),
  anisotropyRotation: angle(0, {
    help: 'Direction of the stretching, from the tangent.',
    label: 'Anisotropy rotation',
    ...physical,
  }),
  thickness: number(0, {
    unit: 'm',
    min: 0,
    step: 0.01,
    help: 'Thickness that light passes through; 0 is a thin sheet, which does not bend it.',
    ...physical,
  }),
  attenuationDistance: number(0, {
    unit: 'm',
    min: 0,
    step: 0.1,
    help: 'Depth at which light has taken the attenuation colour; 0 for never.',
    label: 'Attenuation distance',
    ...physical,
  }),
  attenuationColour: colour([1, 1, 1], {
    help: 'What is left of white light at the attenuation distance.',
    label: 'Attenuation colour',
    ...physical,
  }),
  dispersion: number(0, { min: 0, max: 20, step: 0.1, help: 'How far colours split where light bends.', ...physical }),
  diffuseRoughness: number(0, {
    ...part,
    help: 'Roughness of diffuse reflection, as of clay: the rim gets lighter.',
    label: 'Diffuse roughness',
    ...physical,
  }),
  retroreflectivity: number(0, {
    ...part,
    help: 'Sends light back to where it came from, as road signs do.',
    ...physical,
  }),
  specularIntensity: number(1, {
    ...part,
    help: 'Strength of the reflections of non-metals.',
    label: 'Specular intensity',
    ...physical,
  }),
  specularColour: colour([1, 1, 1], {
    help: 'Colour of the reflections of non-metals.',
    label: 'Specular colour',
    ...physical,
  }),
  depthWrite: boolean(true, {
    help: 'Hide what lies behind, even where it is transparent. Off for most transparent things.',
    label: 'Write depth',
  }),
  side: choice('front', ['front', 'back'], {
    help: 'Which side of triangles is drawn.',
    label: 'Side',
    visibleWhen: { field: 'doubleSided', equals: [false] },
  }),
  ...Object.assign({}, ...materialMapNames.map(fieldsOfMap)),
  surface: asset('surface', null, {
    help: 'Waves, rust, snow and the like: GLSL that changes look and shape.',
    label: 'Surface effect',
  }),
  ...surfaceValueFields,
};
