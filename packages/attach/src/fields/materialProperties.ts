import { boolean, colour, number } from '@farol/editing/fields';
import { BackSide, DoubleSide, FrontSide, type Material } from 'three';
import { declare, declareConstant } from './declare';

/** Marks a material for recompiling, after a change of a property that its program depends on. */
const recompile = (target: object) => void ((target as Material).needsUpdate = true);

const share = (help: string) => number(0, { min: 0, max: 1, step: 0.01, help });
const tint = (help: string, label?: string) => colour([1, 1, 1], { help, label });

/** Properties of materials; a material shows those that its three class has. */
export const materialProperties = [
  declare('color', tint('Colour of the surface; of metals, of its reflections.', 'Colour')),
  declare('emissive', tint('Light that it emits.')),
  declare('emissiveIntensity', number(1, { min: 0, step: 0.1, help: 'Factor of the light that it emits.' })),
  declare('roughness', share('0 is a mirror, 1 is chalk.')),
  declare('metalness', share('1 for metals, 0 for all else.')),
  declare('specular', tint('Colour of the highlight.')),
  declare('shininess', number(30, { min: 0, step: 1, help: 'Sharpness of the highlight.' })),
  declare('clearcoat', share('A layer of varnish.'), recompile),
  declare('clearcoatRoughness', share('Roughness of the varnish.')),
  declare('sheen', share('Strength of the gloss of cloth.'), recompile),
  declare('transmission', share('Share of light that passes through.'), recompile),
  declare('ior', number(1.5, { min: 1, max: 2.333, step: 0.01, label: 'Refraction', help: 'Index of refraction.' })),
  declare('envMapIntensity', number(1, { min: 0, step: 0.1, label: 'Environment', help: 'Strength of reflections.' })),
  declare('opacity', share('Of transparent materials: 0 is invisible.')),
  declare('transparent', boolean(false, { help: 'Blended over what is behind it, back to front.' }), recompile),
  declare('alphaTest', share('Pixels of less opacity are left out.'), recompile),
  declareConstant(
    'side',
    'Which side of a face is drawn.',
    { Front: FrontSide, Back: BackSide, Both: DoubleSide },
    recompile,
  ),
  declare('flatShading', boolean(false, { help: 'Every face by its own normal.' }), recompile),
  declare('wireframe', boolean(false, { help: 'Edges only.' })),
  declare('visible', boolean(true, { help: 'Whether it draws at all.' })),
  declare('depthTest', boolean(true, { help: 'Hidden by what is before it.' })),
  declare('depthWrite', boolean(true, { help: 'Hides what is behind it.' })),
];
