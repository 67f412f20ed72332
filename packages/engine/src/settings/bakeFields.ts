import { asset, boolean, choice, number } from '@farol/editing/fields';

/** Widths of lightmaps to choose from (texels). */
export const lightmapSizes = ['64', '128', '256', '512', '1024', '2048', '4096'] as const;

/** Fields for the baked light of a scene, and for the options of a bake. */
export const bakeFields = {
  bakedLight: asset('bake', null, { help: 'Lightmaps and probes that light the scene.', label: 'Baked light' }),
  bakeSize: choice('1024', lightmapSizes, {
    help: 'Width and height of a lightmap, in texels.',
    label: 'Lightmap size',
  }),
  bakeTexelsPerMetre: number(0, {
    unit: 'texels/m',
    min: 0,
    max: 1000,
    step: 1,
    help: 'Texels along a metre of surface, in as many lightmaps as that takes; 0 for as many as one lightmap has room for.',
    label: 'Resolution',
  }),
  bakeBounces: number(3, {
    min: 0,
    max: 16,
    integer: true,
    help: 'How often light is reflected before it arrives; 0 for direct light alone.',
    label: 'Bounces',
  }),
  bakeSamples: number(256, {
    min: 1,
    max: 65536,
    integer: true,
    help: 'Paths of light to each texel: more take longer and leave less noise.',
    label: 'Samples',
  }),
  bakeSky: boolean(true, { help: 'Sky and environment light what is baked.', label: 'Light from the sky' }),
  bakeDenoise: boolean(true, { help: 'Takes out the noise that is left.', label: 'Denoise' }),
  bakeStitch: boolean(true, {
    help: 'Makes light agree on both sides where a smooth surface is cut for its lightmap; else the cuts may show as lines.',
    label: 'Stitch seams',
  }),
  bakeProbes: boolean(true, {
    help: 'Light probes, by which baked light reaches objects that are not static.',
    label: 'Light probes',
  }),
  bakeProbeSpacing: number(1, {
    unit: 'm',
    min: 0.05,
    max: 100,
    step: 0.1,
    help: 'Distance between light probes, at least; farther where there would be too many.',
    label: 'Probe spacing',
    visibleWhen: { field: 'bakeProbes', equals: [true] },
  }),
};
