import {
  angle,
  asset,
  boolean,
  choice,
  colour,
  custom,
  type FieldCondition,
  type FieldType,
  number,
  string,
} from '@farol/editing/fields';
import { antialiasingEffects, effectEntries, effectFields } from './effectFields';
import { exposureFields } from './exposureFields';
import { focusFields } from './focusFields';
import { toneMappingLabels, toneMappingNames } from './toneMappings';

/** Condition that shows a field only while a switch is on. */
const on = (field: string): { visibleWhen: FieldCondition } => ({ visibleWhen: { field, equals: [true] } });
const when = (field: string, ...equals: string[]): { visibleWhen: FieldCondition } => ({
  visibleWhen: { field, equals },
});

/** Names of the renderer's `techniques`. An unknown name is replaced by the renderer's default. */
export const techniqueType: FieldType = {
  name: 'technique',
  allows: 'the name of a technique, of 1 to 100 letters',
  check: (value) => typeof value === 'string' && value.length > 0 && value.length <= 100,
};

/** Skies that are made in code. */
export const skyPresets = ['clear-day', 'overcast', 'sunset', 'night', 'studio'] as const;
export type SkyPreset = (typeof skyPresets)[number];

/** Sky presets with a sun or a moon. */
export const skiesWithSun = ['clear-day', 'sunset', 'night'] as const satisfies readonly SkyPreset[];

export const skyFields = {
  background: choice('colour', ['colour', 'gradient', 'sky', 'environment'], {
    help: 'What is seen where there is no object.',
    optionLabels: { colour: 'Colour', gradient: 'Gradient', sky: 'Sky', environment: 'Environment' },
  }),
  backgroundColour: colour([0.02, 0.025, 0.035], {
    help: 'Colour behind the objects.',
    label: 'Background colour',
    ...when('background', 'colour', 'environment'),
  }),
  sky: choice('clear-day', skyPresets, {
    help: 'A sky that is made in code.',
    label: 'Preset',
    optionLabels: {
      'clear-day': 'Clear day',
      overcast: 'Overcast',
      sunset: 'Sunset',
      night: 'Night',
      studio: 'Studio',
    },
    ...when('background', 'sky'),
  }),
  placeSun: boolean(false, {
    help: 'Put the sun, or the moon, where two angles say, not where the preset has it.',
    label: 'Place the sun',
    ...when('sky', ...skiesWithSun),
  }),
  sunAzimuth: angle((-115 * Math.PI) / 180, {
    min: -Math.PI,
    max: Math.PI,
    help: 'Direction of the sun on the compass, from +x towards +z.',
    label: 'Sun azimuth',
    ...on('placeSun'),
  }),
  sunElevation: angle((38 * Math.PI) / 180, {
    min: 0,
    max: Math.PI / 2,
    help: 'How high the sun stands above the horizon.',
    label: 'Sun elevation',
    ...on('placeSun'),
  }),
  skyTop: colour([0.08, 0.2, 0.5], { help: 'Colour straight above.', label: 'Top', ...when('background', 'gradient') }),
  skyHorizon: colour([0.55, 0.65, 0.75], {
    help: 'Colour at the horizon.',
    label: 'Horizon',
    ...when('background', 'gradient'),
  }),
  skyGround: colour([0.12, 0.11, 0.1], {
    help: 'Colour straight below.',
    label: 'Ground',
    ...when('background', 'gradient'),
  }),
  environment: asset('texture', null, {
    help: 'Equirectangular texture that lights every standard and physical material from all sides.',
    ...when('background', 'colour', 'environment'),
  }),
  skyLight: boolean(true, {
    help: 'The sky lights every standard and physical material from all sides.',
    label: 'Light from the sky',
    ...when('background', 'gradient', 'sky'),
  }),
  environmentIntensity: number(1, {
    min: 0,
    step: 0.05,
    help: 'Factor of the light that comes from the environment or the sky, and of how bright it is seen.',
    label: 'Environment intensity',
  }),
  backgroundIntensity: number(1, {
    min: 0,
    step: 0.05,
    help: 'Factor of how bright the sky is seen; it lights the scene the same.',
    label: 'Background intensity',
    ...when('background', 'gradient', 'sky', 'environment'),
  }),
  backgroundRotation: angle(0, {
    min: -2 * Math.PI,
    max: 2 * Math.PI,
    help: 'Turns environment and sky about the vertical.',
    label: 'Rotation',
  }),
  backgroundBlur: number(0, {
    min: 0,
    max: 1,
    step: 0.05,
    help: 'How blurred the sky is seen; 0 is sharp.',
    label: 'Blur',
    ...when('background', 'sky', 'environment'),
  }),
};

export const fogFields = {
  fog: choice('none', ['none', 'linear', 'exponential'], {
    help: 'Fog that fades objects into a colour.',
    optionLabels: { none: 'None', linear: 'Linear', exponential: 'Exponential' },
  }),
  fogFromSky: boolean(false, {
    help: 'The fog has the colour of the sky at the horizon, or of the background.',
    label: 'Colour from the sky',
    ...when('fog', 'linear', 'exponential'),
  }),
  fogColour: colour([0.5, 0.55, 0.6], {
    help: 'Colour of the fog.',
    label: 'Fog colour',
    visibleWhen: { field: 'fogFromSky', equals: [false] },
  }),
  fogNear: number(10, {
    unit: 'm',
    min: 0,
    help: 'Distance where the fog begins.',
    label: 'Fog near',
    ...when('fog', 'linear'),
  }),
  fogFar: number(100, {
    unit: 'm',
    min: 0,
    help: 'Distance of full fog.',
    label: 'Fog far',
    ...when('fog', 'linear'),
  }),
  fogDensity: number(0.02, {
    unit: '1/m',
    min: 0,
    step: 0.001,
    help: 'Growth of exponential fog with distance.',
    label: 'Fog density',
    ...when('fog', 'exponential'),
  }),
};

export const toneMappingFields = {
  toneMapping: choice('none', toneMappingNames, {
    help: 'How light of any brightness becomes colours of a screen; three’s tone mappings.',
    label: 'Tone mapping',
    optionLabels: toneMappingLabels,
  }),
  ...exposureFields('factor', 'Factor'),
  exposure: number(1, {
    min: 0,
    max: 1000,
    step: 0.05,
    help: 'Factor of all light before it is tone mapped.',
    visibleWhen: {
      ...{ field: 'exposureBy', equals: ['factor'] },
      and: { field: 'toneMapping', equals: toneMappingNames.slice(1) },
    },
  }),
};

export const bloomFields = {
  bloom: boolean(false, { help: 'Bright things glow over their surroundings.' }),
  bloomIntensity: number(0.6, {
    min: 0,
    max: 10,
    step: 0.05,
    help: 'How much they glow.',
    label: 'Strength',
    ...on('bloom'),
  }),
  bloomThreshold: number(1, {
    min: 0,
    max: 100,
    step: 0.05,
    help: 'Luminance from which on things glow; 1 is a white surface in full light.',
    label: 'Threshold',
    ...on('bloom'),
  }),
  bloomRadius: number(0.8, {
    min: 0,
    max: 1,
    step: 0.01,
    help: 'How far it reaches.',
    label: 'Radius',
    ...on('bloom'),
  }),
};

export const depthOfFieldFields = {
  depthOfField: boolean(false, {
    help: 'What is nearer or farther than the focus is blurred. A camera can have its own.',
    label: 'Depth of field',
  }),
  ...focusFields(on('depthOfField')),
};

export const gradingFields = {
  grading: boolean(false, { help: 'Changes the colours of the finished picture.', label: 'Colour grading' }),
  temperature: number(0, { min: -1, max: 1, step: 0.02, help: 'Below 0 cooler, above 0 warmer.', ...on('grading') }),
  tint: number(0, { min: -1, max: 1, step: 0.02, help: 'Below 0 greener, above 0 more magenta.', ...on('grading') }),
  contrast: number(0, { min: -1, max: 1, step: 0.02, help: 'Below 0 flatter, above 0 stronger.', ...on('grading') }),
  saturation: number(0, { min: -1, max: 1, step: 0.02, help: '-1 is grey, above 0 more colourful.', ...on('grading') }),
  lut: asset('texture', null, {
    help: 'Table of colours (LUT): a .cube file, or an image of its slices in a row.',
    label: 'Look-up table',
    ...on('grading'),
  }),
  lutStrength: number(1, {
    min: 0,
    max: 1,
    step: 0.05,
    help: 'How much of the look-up table is seen.',
    label: 'Table strength',
    ...on('grading'),
  }),
};

export const vignetteFields = {
  vignette: boolean(false, { help: 'The picture darkens towards its corners.' }),
  vignetteDarkness: number(0.5, {
    min: 0,
    max: 1,
    step: 0.02,
    help: 'How dark the corners are.',
    label: 'Darkness',
    ...on('vignette'),
  }),
  vignetteSize: number(0.5, {
    min: 0,
    max: 1,
    step: 0.02,
    help: 'How far it reaches into the picture.',
    label: 'Reach',
    ...on('vignette'),
  }),
};

export const shadowFields = {
  shadowKind: choice('soft', ['none', 'hard', 'soft', 'variance'], {
    help: 'How shadows are drawn. Variance blurs them widely, but not those of point lights, and light may leak through.',
    label: 'Shadows',
    optionLabels: { none: 'Off', hard: 'Hard', soft: 'Soft (PCF)', variance: 'Variance (VSM)' },
  }),
  shadowSoftness: number(1, {
    min: 0,
    max: 10,
    step: 0.1,
    help: 'Factor of the softness of every light’s shadows.',
    label: 'Softness',
    ...when('shadowKind', 'soft', 'variance'),
  }),
  shadowCascades: number(1, {
    min: 1,
    max: 4,
    integer: true,
    help: 'Shadow maps of each directional light: each one more is finer near the camera.',
    label: 'Cascades',
    ...when('shadowKind', 'hard', 'soft'),
  }),
};

export const renderingFields = {
  technique: custom(techniqueType, 'auto', { help: 'How the scene is lit and drawn; "Automatic" picks the fastest.' }),
  quality: choice('auto', ['auto', 'full', 'lite'], {
    help: 'Lite holds less memory for surfaces and shadows. Automatic takes it on phones and weak devices.',
    optionLabels: { auto: 'Automatic', full: 'Full', lite: 'Lite' },
  }),
  antialiasing: choice('auto', ['auto', 'none', ...antialiasingEffects], {
    help: 'How edges are smoothed. Automatic is multisampled where the technique can be, else SMAA; TAA gathers frames.',
    label: 'Anti-aliasing',
    optionLabels: {
      auto: 'Automatic',
      none: 'Of the technique',
      ...Object.fromEntries(antialiasingEffects.map((name) => [name, effectEntries[name].label])),
    },
  }),
  ...effectFields,
  frameBudget: choice('auto', ['auto', 'on', 'off'], {
    help: 'Whether the scene is drawn smaller, and enlarged, where its frames would take longer than 16.7 ms.',
    label: 'Frame budget',
    optionLabels: { auto: 'On touch screens', on: 'On', off: 'Off ## budget' },
  }),
  pluginEffects: string('', {
    help: 'Names of effects of plugins that are on, with commas between them.',
    label: 'Effects of plugins',
  }),
};

/** Fields for the picture of a scene, apart from its objects. */
export const pictureFields = {
  ...skyFields,
  ...fogFields,
  ...toneMappingFields,
  ...bloomFields,
  ...depthOfFieldFields,
  ...gradingFields,
  ...vignetteFields,
  ...shadowFields,
  ...renderingFields,
};
