import {
  AddEquation,
  CustomBlending,
  KeepStencilOp,
  LessEqualDepth,
  NotEqualStencilFunc,
  OneFactor,
  ReplaceStencilOp,
  ShaderChunk,
} from 'three';
import type { View } from '../../frame/views';
import { isCountView } from '../../frame/views';
import { litTwin } from '../../materials/litTwin';
import { findChunk, replaceChunk, replacePart } from '../../three/replaceChunk';
import type { LightLoop } from '../../materials/LightLoop';
import type { TwinKind } from '../../materials/TwinKind';

const NOTHING = 'gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0);';

/** Dithers by the pixel's position in the host's target, as three does. */
function ditheredInTarget(text: string): string {
  if (findChunk(text, 'dithering_pars_fragment') === null) return text;
  const dithering = ShaderChunk.dithering_pars_fragment.replace('gl_FragCoord.xy', 'farol_targetPixel()');
  return replaceChunk(text, 'dithering_pars_fragment', () => `highp vec2 farol_targetPixel();\n${dithering}`);
}

const BASE = {
  key: 'base',
  role: 'forward',
  isSum: true,
  loop: 'lightLoopOne',
  rewrite: ditheredInTarget,
} as const;
/** Twin of the first pass: ambient, environment and emissive light, lights left to three, and one light. */
const base = litTwin(BASE);
const baseUnfogged = litTwin({ ...BASE, properties: { fog: false } });
const baseDark = litTwin({ key: 'base-dark', loop: 'lightLoopNone', atEnd: NOTHING });

/** @param fogged - false leaves fog to the output pass */
export function baseTwin(view: View, fogged: boolean): TwinKind {
  return view === 'final' || view === 'grid' ? (fogged ? base : baseUnfogged) : baseDark;
}

/** Stencil value of the light being drawn, 1 to 255, so that it is added to one of several surfaces at one depth. */
export const lightMark = { value: 1 };

const ADDITIVE = {
  blending: CustomBlending,
  blendEquation: AddEquation,
  blendSrc: OneFactor,
  blendDst: OneFactor,
  blendEquationAlpha: null,
  blendSrcAlpha: null,
  blendDstAlpha: null,
  depthFunc: LessEqualDepth,
  depthWrite: false,
  stencilWrite: true,
  stencilFunc: NotEqualStencilFunc,
  stencilFuncMask: 255,
  stencilWriteMask: 255,
  stencilFail: KeepStencilOp,
  stencilZFail: KeepStencilOp,
  stencilZPass: ReplaceStencilOp,
  get stencilRef() {
    return lightMark.value;
  },
} as const;

/** MixOperation scales light and adds the environment map; a draw that adds one light must only scale that light. */
const ENVIRONMENT = `#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_CUBE ) && defined( ENVMAP_BLENDING_MIX )
  outgoingLight *= 1.0 - specularStrength * reflectivity;
#elif !defined( USE_ENVMAP ) || !defined( ENVMAP_BLENDING_ADD )
  #include <envmap_fragment>
#endif`;

function onlyThisLight(text: string): string {
  // fog only fades this light; the first pass has added the fog's colour
  const fog = replacePart(ShaderChunk.fog_fragment, 'fogColor', 'vec3(0.0)');
  let own = replaceChunk(text, 'lights_fragment_end', () => 'totalEmissiveRadiance = vec3(0.0);');
  // MeshToonMaterial has no environment map
  if (own.includes('#include <envmap_fragment>')) own = replaceChunk(own, 'envmap_fragment', () => ENVIRONMENT);
  own = replaceChunk(own, 'fog_fragment', () => fog);
  return `#define OPAQUE\n${replaceChunk(own, 'dithering_fragment', () => '')}`;
}

const additive = (count: boolean, fogged = true, loop: LightLoop = 'lightLoopOne') =>
  litTwin({
    // both slots share one program; changing the slot makes three upload the light's index
    key: `${count ? 'additive-count' : 'additive'}-${loop}`,
    loop,
    withThreeLights: false,
    properties: fogged ? ADDITIVE : Object.defineProperties({ fog: false }, Object.getOwnPropertyDescriptors(ADDITIVE)),
    rewrite: onlyThisLight,
    atEnd: count ? 'gl_FragColor = vec4(farol_lightsEvaluated, 0.0, 0.0, 0.0);' : 'gl_FragColor.a = 0.0;',
  });
const additives = [additive(false), additive(false)];
const additivesUnfogged = [additive(false, false), additive(false, false)];
const counters = [additive(true), additive(true)];

const field = additive(false, true, 'lightLoopField');
const fieldUnfogged = additive(false, false, 'lightLoopField');
const fieldCounter = additive(true, true, 'lightLoopField');

/**
 * Returns the twin that adds the lights of fields to earlier draws.
 * @param fogged - false leaves fog to the output
 */
export function fieldTwin(view: View, fogged: boolean): TwinKind {
  return isCountView(view) ? fieldCounter : fogged ? field : fieldUnfogged;
}

/**
 * Returns the twin that adds one light to earlier draws. Two kinds share one program, and lights alternate between them: three
 * uploads a material's uniforms only when the material changes.
 * @param fogged - false leaves fog to the output
 */
export function additiveTwin(view: View, slot: 0 | 1, fogged: boolean): TwinKind {
  return (isCountView(view) ? counters : fogged ? additives : additivesUnfogged)[slot];
}
