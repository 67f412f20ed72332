import { ShaderChunk } from 'three';
import type { MicroShader } from '../MicroShader';

const UNDEFINE = ['RE_Direct', 'RE_Direct_RectArea', 'RE_IndirectDiffuse', 'RE_IndirectSpecular']
  .map((name) => `#undef ${name}`)
  .join('\n');

/**
 * three's physical and Blinn-Phong lighting functions side by side, without the macros by which a material picks one,
 * and without rectangle lights, whose count would change the program.
 */
export const threeLighting: MicroShader = {
  name: 'threeLighting',
  dependencies: [],
  main: '',
  header: `// three's own lighting functions, both models at once.
// three.js r187, lights_physical_pars_fragment and lights_phong_pars_fragment
#include <common>
#include <bsdfs>
${ShaderChunk.lights_physical_pars_fragment.replaceAll('NUM_RECT_AREA_LIGHTS', '0')}
${UNDEFINE}
${ShaderChunk.lights_phong_pars_fragment.replace('varying vec3 vViewPosition;', '')}
${UNDEFINE}
`,
};
