import { angle, asset, boolean, choice, colour, number, object } from '@farol/editing/fields';
import { HIGHEST_KELVIN, LOWEST_KELVIN } from '../photometry/colourTemperature';
import { lampKinds } from '../photometry/lampKinds';
import { intensityUnits, unitLabels } from '../photometry/lightUnits';

const withPlace = { visibleWhen: { field: 'type', equals: ['point', 'spot'] } };
const withDirectColour = { visibleWhen: { field: 'type', equals: ['directional', 'point', 'spot'] } };
const spot = { visibleWhen: { field: 'type', equals: ['spot'] } };
const withArea = { visibleWhen: { field: 'type', equals: ['rectangle', 'disc', 'tube'] } };
const withShadow = { field: 'type', equals: ['directional', 'point', 'spot', 'rectangle', 'disc', 'tube'] };
const casts = { field: 'castShadow', equals: [true] };
const shadow = { visibleWhen: casts, group: 'Shadow' };
/** Condition of fields for lights without a size: the size of an area light sets the softness of its shadows. */
const hardShadow = {
  visibleWhen: { ...casts, and: { field: 'type', equals: ['directional', 'point', 'spot'] } },
  group: 'Shadow',
};
const baked = { field: 'mode', equals: ['mixed', 'baked'] };
const fading = { group: 'Fading' };
const nearFar = { visibleWhen: { field: 'attenuation', equals: ['near-far'] }, ...fading };
const polynomial = { visibleWhen: { field: 'attenuation', equals: ['polynomial'] }, ...fading };
const unitOf = (unit: string, ...types: string[]) => Object.fromEntries(types.map((type) => [type, { unit }]));
const nits = unitOf('nt', 'rectangle', 'disc', 'tube');

/** The fields of a Light (thesis 3.2.5.3, with its two attenuations and three's physical falloff). */
export const lightFields = {
  type: choice('point', ['ambient', 'hemisphere', 'directional', 'point', 'spot', 'rectangle', 'disc', 'tube'], {
    help: 'How the light spreads.',
  }),
  colourBy: choice('hand', ['hand', 'temperature'], {
    help: 'Whether the colour is chosen by hand, or is that of a temperature.',
    label: 'Colour by',
    optionLabels: { hand: 'Hand', temperature: 'Temperature' },
  }),
  diffuse: colour([1, 1, 1], {
    help: 'Colour of the light; of the sky, for a hemisphere.',
    label: 'Colour',
    visibleWhen: { field: 'colourBy', equals: ['hand'] },
  }),
  kelvin: number(4000, {
    unit: 'K',
    min: LOWEST_KELVIN,
    max: HIGHEST_KELVIN,
    step: 10,
    input: 'temperature',
    help: 'Colour temperature: 1,850 K is a candle, 2,700 K a bulb, 6,500 K daylight. Lumens stay whatever it is.',
    label: 'Temperature',
    visibleWhen: { field: 'colourBy', equals: ['temperature'] },
  }),
  groundColour: colour([0.1, 0.08, 0.06], {
    help: 'Light from below.',
    label: 'Ground colour',
    visibleWhen: { field: 'type', equals: ['hemisphere'] },
  }),
  intensity: number(1, {
    unit: 'cd or lx or nt',
    unitBy: {
      field: 'type',
      units: {
        ...{ ambient: 'lx', hemisphere: 'lx', directional: 'lx', point: 'cd', spot: 'cd' },
        ...{ rectangle: 'nt', disc: 'nt', tube: 'nt' },
      },
    },
    min: 0,
    step: 0.1,
    input: 'intensity',
    variants: {
      field: 'type',
      of: { ...unitOf('lx', 'ambient', 'hemisphere', 'directional'), ...unitOf('cd', 'point', 'spot'), ...nits },
    },
    help: 'Candela for point and spot lights, nits (cd/m²) for rectangles, discs and tubes, lux for the others; multiplies every colour of the light.',
  }),
  intensityUnit: choice('auto', ['auto', ...intensityUnits], {
    help: 'Unit that the intensity is shown and typed in; the light is the same. Lux of point and spot lights is at 1 m.',
    label: 'Unit',
    optionLabels: { auto: 'Automatic', ...unitLabels },
    besideField: 'intensity',
  }),
  lamp: choice('led', lampKinds, {
    help: 'Kind of lamp whose watts stand for the light.',
    optionLabels: { incandescent: 'Incandescent', halogen: 'Halogen', fluorescent: 'Fluorescent', led: 'LED' },
    besideField: 'intensity',
  }),
  group: object(null, {
    help: 'Object with a Light Group, whose dimmer and colour multiply those of the light.',
    label: 'Light group',
    noneLabel: 'No group',
  }),
  width: number(1, {
    unit: 'm',
    min: 0.001,
    step: 0.05,
    variants: { field: 'type', of: { tube: { label: 'Length' } } },
    help: 'Width of the shape that shines; of a tube: its length.',
    ...withArea,
  }),
  height: number(1, {
    unit: 'm',
    min: 0.001,
    step: 0.05,
    variants: { field: 'type', of: { tube: { label: 'Thickness' } } },
    help: 'Height of the shape that shines; of a tube: how thick it is.',
    ...withArea,
  }),
  areaRange: number(0, {
    unit: 'm',
    min: 0,
    step: 0.1,
    help: 'Distance from the shape where the light ends, fading from half of it on; 0: where it gives next to nothing.',
    label: 'Range',
    ...withArea,
  }),
  profile: asset('profile', null, {
    help: 'Photometric file of a luminaire: how much light it gives in which direction.',
    group: 'Profile',
    ...withPlace,
  }),
  profileIntensity: boolean(false, {
    help: 'Shine as brightly as the file says: the intensity is then a factor, 1 for that of the file.',
    label: 'Brightness of the file',
    group: 'Profile',
    ...withPlace,
  }),
  mode: choice('realtime', ['realtime', 'mixed', 'baked'], {
    help: 'Baked light is in lightmaps and probes and costs nothing; of a mixed light only what surfaces reflect is baked.',
    optionLabels: { realtime: 'Realtime', mixed: 'Mixed', baked: 'Baked' },
  }),
  ambient: colour([0, 0, 0], {
    help: 'Light added to every surface in reach, whichever way it faces.',
    label: 'Ambient colour',
    group: 'Ambient and highlights',
    ...withDirectColour,
  }),
  ownSpecular: boolean(false, {
    help: 'Give highlights a colour of their own.',
    label: 'Own highlight colour',
    group: 'Ambient and highlights',
    ...withDirectColour,
  }),
  specular: colour([1, 1, 1], {
    help: 'Colour of highlights.',
    label: 'Highlight colour',
    group: 'Ambient and highlights',
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
  bakedRadius: number(0.05, {
    unit: 'm',
    min: 0,
    max: 10,
    step: 0.01,
    help: 'Radius of what shines: the larger, the softer are its baked shadows.',
    label: 'Source radius',
    group: 'Baking',
    visibleWhen: { ...baked, and: { field: 'type', equals: ['point', 'spot'] } },
  }),
  bakedAngle: angle(0.01, {
    min: 0,
    max: 1,
    step: 0.01,
    help: 'Angle that the source covers, 0.5° for the sun: the larger, the softer are its baked shadows.',
    label: 'Source angle',
    group: 'Baking',
    visibleWhen: { ...baked, and: { field: 'type', equals: ['directional'] } },
  }),
  castShadow: boolean(false, {
    help: 'Whether objects cast shadows in it.',
    label: 'Cast shadow',
    group: 'Shadow',
    visibleWhen: withShadow,
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
    ...hardShadow,
  }),
  shadowBias: number(-0.0005, {
    min: -0.1,
    max: 0.1,
    step: 0.0001,
    help: 'Offset of depth, against stripes on lit surfaces.',
    label: 'Shadow bias',
    ...hardShadow,
  }),
  shadowNormalBias: number(0.02, {
    unit: 'm',
    min: 0,
    max: 10,
    step: 0.01,
    help: 'Offset along normals, against stripes on lit surfaces.',
    label: 'Shadow normal bias',
    ...shadow,
  }),
  shadowExtent: number(20, {
    unit: 'm',
    min: 0.01,
    help: 'Half the width of the area in which a directional light casts shadows.',
    label: 'Shadow extent',
    group: 'Shadow',
    visibleWhen: { ...casts, and: { field: 'type', equals: ['directional'] } },
  }),
};
