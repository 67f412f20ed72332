/** Cases that a technique draws otherwise than stock three, and why. The README lists them too. */
export interface Exception {
  readonly technique: string;
  /** By sheet and name: signal to noise (dB) and share of pixels off by more than 2/255 (0 to 1), as measured. */
  readonly cases: Readonly<Record<string, readonly [psnr: number, share: number]>>;
  readonly reason: string;
}

/** How much farther off than measured a case may be (dB), and by how many more pixels (factor). */
const LESS = 2;
const MORE = 1.25;

/** All exceptions of the matrix. */
export const matrixExceptions: readonly Exception[] = [
  {
    technique: 'inferred',
    // each setting has a transparent ball
    cases: {
      'maps: vertex colours with alpha': [55.2, 0.0176],
      'maps: transparent': [48.5, 0.043],
      'maps: transparent, both sides': [44.1, 0.0655],
      'maps: transparent, both sides in one pass': [51.2, 0.0157],
      'maps: additive blending': [54.7, 0.0206],
      'maps: blended by maximum': [42.4, 0.0528],
      'maps: premultiplied alpha': [46.1, 0.0362],
      'geometry: skinned, transparent': [38.7, 0.0381],
      'order: transparent things by render order': [46.2, 0.0332],
      'glTF: alpha blend': [45.2, 0.0372],
      'settings: camera off centre': [45.4, 0.0298],
      'settings: orthographic camera off centre': [42.3, 0.0357],
      'settings: several cameras, with viewport and scissor': [37.1, 0.0414],
      'settings: array of cameras': [33.5, 0.0342],
      'settings: layers of the camera': [44.3, 0.0274],
      'settings: autoClear off, two scenes, stock three between': [44.9, 0.0214],
      'settings: a group in place of a scene': [45, 0.0254],
      'settings: not sorted': [44.3, 0.0274],
      'settings: clipping planes of the renderer': [47.1, 0.011],
      'settings: override material, lit': [41.7, 0.0344],
      'settings: fog, linear': [45, 0.0272],
      'settings: fog, exponential': [46.4, 0.0295],
      'settings: background of a texture': [44.3, 0.0274],
      'settings: background of a cube, fainter and turned': [43.4, 0.0292],
      'settings: background of an equirectangular map, blurred': [44.2, 0.0284],
      'settings: no background, a clear colour that is half transparent': [42.9, 0.0308],
      'settings: environment, turned and strong': [49.6, 0.0202],
      'settings: rectangle light and probe': [45, 0.0251],
      'settings: environment without a mapping': [44.3, 0.0273],
      'settings: transmission': [44.3, 0.0274],
      'settings, 8 bits: target of 8 bits in sRGB': [51.2, 0.017],
      'settings: camera in a group that is moved': [44.5, 0.0258],
      'settings: a scene that updates no matrices': [44.3, 0.0274],
      'settings: two FarolRenderers on one WebGLRenderer, one made anew': [44.3, 0.0274],
      'settings, 8 bits: canvas': [47.8, 0.0196],
      'settings, 8 bits: canvas, tone mapping and fog, but not for all': [51.6, 0.0095],
      'settings, 8 bits: canvas of linear colours': [47, 0.0168],
      'settings, 8 bits: canvas with a pixel ratio, after a change of size': [47.8, 0.0196],
      'settings: logarithmic depth': [44.3, 0.0274],
      'settings: logarithmic depth, orthographic': [42.3, 0.0357],
      'settings: reversed depth': [44.3, 0.0274],
      'settings: reversed depth, orthographic': [42.3, 0.0357],
      'settings, 8 bits: canvas through a buffer of half floats': [47.1, 0.0183],
    },
    reason:
      'a transparent layer is lit at one texel of each two by two, and by what is nearest to it in the light buffer',
  },
  {
    technique: 'forward',
    cases: {
      'maps: alpha test of a map, both sides': [52.6, 0.001],
    },
    reason: 'of two surfaces at exactly one depth in a pixel, the first gets the lights, where three shows the second',
  },
];

/** The limits of a case that is known to be drawn otherwise by a technique: signal to noise, at least, and share, at most. */
export function exceptionOf(technique: string, name: string): { psnr: number; share: number } | undefined {
  const measured = matrixExceptions.find((exception) => exception.technique === technique)?.cases[name];
  return measured && { psnr: measured[0] - LESS, share: measured[1] * MORE };
}

/** Exceptions of a sheet whose case is none of `names`, which are all of it. */
export function strayExceptions(sheet: string, names: readonly string[]): string[] {
  const known = new Set(names.map((name) => `${sheet}: ${name}`));
  const cases = matrixExceptions.flatMap((exception) => Object.keys(exception.cases));
  return cases.filter((name) => name.startsWith(`${sheet}: `) && !known.has(name));
}
