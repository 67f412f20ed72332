import { angle, boolean, choice, colour, number } from '../fields/fields';

const withPlace = { visibleWhen: { field: 'type', equals: ['point', 'spot'] } };
const withDirectColour = { visibleWhen: { field: 'type', equals: ['directional', 'point', 'spot'] } };
const spot = { visibleWhen: { field: 'type', equals: ['spot'] } };
const shadow = { visibleWhen: { field: 'castShadow', equals: [true] }, group: 'Shadow' };
const fading = { group: 'Fading' };
const nearFar = { visibleWhen: { field: 'attenuation', equals: ['near-far'] }, ...fading };
const polynomial = { visibleWhen: { field: 'attenuation', equals: ['polynomial'] }, ...fading };

/** The fields of a Light (thesis 3.2.5.3, with three's physical falloff beside its two attenuations). */
export const lightFields = {
  type: choice('point', ['ambient', 'hemisphere', 'directional', 'point', 'spot'], { help: 'How the light spreads.' }),
  diffuse: colour([1, 1, 1], { help: 'Colour of the light; of the sky, for a hemisphere.', label: 'Colour' }),
  groundColour: colour([0.1, 0.08, 0.06], {
    help: 'Light from below.',
    label: 'Ground colour',
    visibleWhen: { field: 'type', equals: ['hemisphere'] },
  }),
  intensity: number(1, {
    unit: 'cd or lx',
    min: 0,
    step: 0.1,
    help: 'Candela for point and spot lights, lux for the others; multiplies every colour of the light.',
  }),
  ambient: colour([0, 0, 0], {
    help: 'Light added to every surface in reach, whichever way it faces.',
    label: 'Ambient colour',
    group: 'More colours',
    ...withDirectColour,
  }),
  ownSpecular: boolean(false, {
    help: 'Give highlights a colour of their own.',
    label: 'Own highlight colour',
    group: 'More colours',
    ...withDirectColour,
  }),
  specular: colour([1, 1, 1], {
    help: 'Colour of highlights.',
    label: 'Highlight colour',
    group: 'More colours',
    visibleWhen: { field: 'ownSpecular', equals: [true] },
  }),
  cutoff: angle(Math.PI / 6, {
    min: 0.01,
    max: Math.PI / 2,
    help: 'Angle from the axis to the edge of the cone.',
    label: 'Cutoff angle',
    ...spot,
  }),
  penumbra: number(0.3, { min: 0, max: 1, step: 0.01, help: 'Part of the cone in which the edge is soft.', ...spot }),
  exponent: number(0, {
    min: 0,
    max: 1000,
    help: 'Above 0: light fades as this power of the cosine from the axis, in place of the penumbra.',
    ...spot,
  }),
  attenuation: choice('physical', ['physical', 'near-far', 'polynomial'], {
    help: "How light fades with distance: three's physical falloff, from near to far, or by three coefficients.",
    ...fading,
    ...withPlace,
  }),
  range: number(10, {
    unit: 'm',
    min: 0,
    step: 0.1,
    help: 'Distance where the light ends; 0 for a physical light without end.',
    ...fading,
    visibleWhen: { field: 'attenuation', equals: ['physical', 'polynomial'] },
  }),
  decay: number(2, {
    min: 0,
    max: 10,
    step: 0.1,
    help: 'Power of the distance by which light fades; 2 in nature.',
    ...fading,
    visibleWhen: { field: 'attenuation', equals: ['physical'] },
  }),
  near: number(1, { unit: 'm', min: 0, step: 0.1, help: 'Distance up to which the light is full.', ...nearFar }),
  far: number(10, { unit: 'm', min: 0.001, step: 0.1, help: 'Distance from which there is no light.', ...nearFar }),
  constant: number(1, { min: 0, step: 0.05, help: 'c in 1 / (c + l d + q d²).', ...polynomial }),
  linear: number(0, { unit: '1/m', min: 0, step: 0.05, help: 'l in 1 / (c + l d + q d²).', ...polynomial }),
  quadratic: number(1, { unit: '1/m²', min: 0, step: 0.05, help: 'q in 1 / (c + l d + q d²).', ...polynomial }),
  castShadow: boolean(false, {
    help: 'Whether objects throw shadows in it.',
    label: 'Cast shadow',
    group: 'Shadow',
    ...withDirectColour,
  }),
  shadowMapSize: number(1024, {
    unit: 'texels',
    min: 16,
    max: 8192,
    integer: true,
    help: 'Width and height of the shadow map.',
    label: 'Shadow map size',
    ...shadow,
  }),
  shadowRadius: number(1, {
    unit: 'texels',
    min: 0,
    max: 20,
    step: 0.1,
    help: 'How far the edges of shadows are blurred.',
    label: 'Shadow softness',
    ...shadow,
  }),
  shadowBias: number(-0.0005, {
    min: -0.1,
    max: 0.1,
    step: 0.0001,
    help: 'Depth by which shadows are moved.',
    label: 'Shadow bias',
    ...shadow,
  }),
  shadowNormalBias: number(0.02, {
    unit: 'm',
    min: 0,
    max: 10,
    step: 0.01,
    help: 'Distance along the normal by which shadows are moved.',
    label: 'Shadow normal bias',
    ...shadow,
  }),
  shadowExtent: number(20, {
    unit: 'm',
    min: 0.01,
    help: 'Half the width of what a directional light throws shadows in.',
    label: 'Shadow extent',
    ...shadow,
  }),
};
