import { Material, ShaderChunk } from 'three';
import { lightLoops, type LightLoop } from './LightLoop';
import { beforeLastBrace } from '../three/beforeLastBrace';
import { withLayers } from './layersAttribute';
import { lightsFragmentBegin } from '../three/lightsFragmentBegin';
import { findChunk, replaceChunk } from '../three/replaceChunk';
import { threeChunks } from '../three/ThreeChunks';
import type { TwinKind, TwinRole, TwinShader } from './TwinKind';
import { TwinRefusal } from '../three/TwinRefusal';

/** Options of `litTwin`. */
export interface LitTwinOptions {
  readonly key: string;
  readonly role?: TwinRole;
  readonly isSum?: boolean;
  readonly loop: LightLoop;
  readonly chunks?: readonly string[];
  /** Whether to shade light by light even if sums over lights would suffice. Default false. */
  readonly oneByOne?: boolean;
  readonly properties?: TwinKind['properties'];
  /** Whether to keep three's own light loops. Default true. */
  readonly withThreeLights?: boolean;
  readonly variant?: (source: Material) => string;
  /** Statements added at the end of main(), where gl_FragColor is complete. */
  readonly atEnd?: string;
  /** Rewrites the fragment shader after all other changes. */
  readonly rewrite?: (fragmentShader: string, source: Material) => string;
}

/** GLSL declaration of the counter, put outside of main(), which the host may have renamed. */
const COUNT = 'float farol_lightsEvaluated;\n';
/** Define that marks a header with the code of light layers. */
const LAYERS = '#define FAROL_LAYERS';

/** Rotates the disk of three's own soft shadows by the pixel's position in the host's target. */
function shadowsInTarget(text: string): string {
  if (findChunk(text, 'shadowmap_pars_fragment') === null) return text;
  const pars = ShaderChunk.shadowmap_pars_fragment.replaceAll('gl_FragCoord.xy', 'farol_targetPixel()');
  return replaceChunk(text, 'shadowmap_pars_fragment', () => pars);
}

/** Makes a kind of twin for lit materials: three's shader with Farol's light loop. */
export function litTwin(options: LitTwinOptions): TwinKind {
  const chunksOf = (loop: LightLoop, oneByOne: boolean) => [
    ...('readsFew' in lightLoops[loop] ? ['fewLights'] : []),
    ...(oneByOne ? ['lightOneByOne'] : []),
    ...['ambientLight', loop, 'shadeThree', 'targetPixel', ...(options.chunks ?? [])],
  ];
  const chunks = chunksOf(options.loop, options.oneByOne ?? false);
  const ownChunks = chunksOf(options.loop, true);
  // three's toon shading uses derivatives, which vertex shaders lack
  const { perPixel } = lightLoops[options.loop];
  const toonChunks = perPixel ? ['shadeToon', ...chunks] : chunks;
  const ownToonChunks = chunksOf(perPixel ? 'lightLoopAll' : options.loop, false);
  const begin = () => lightsFragmentBegin(options.withThreeLights ?? true);
  return {
    key: options.key,
    ...(options.role && { role: options.role }),
    ...(options.isSum && { isSum: true }),
    chunks(source) {
      // shades light by light if the material or the page may have changed three's lighting functions
      const own = threeChunks.shading || source.onBeforeCompile !== Material.prototype.onBeforeCompile;
      const { isMeshToonMaterial } = source as Material & { isMeshToonMaterial?: boolean };
      if (isMeshToonMaterial) return own ? ownToonChunks : toonChunks;
      return own ? ownChunks : chunks;
    },
    ...(options.properties && { properties: options.properties }),
    ...(options.variant && { variant: options.variant }),
    patch(shader: TwinShader, source: Material, header: string) {
      const { fragmentShader } = shader;
      const isThrees = (source as Material & { isShaderMaterial?: boolean }).isShaderMaterial !== true;
      // three lights materials in which the host has changed shadow look-ups
      if (isThrees && findChunk(fragmentShader, 'shadowmap_pars_fragment') === null) throw new TwinRefusal();
      const normal = findChunk(fragmentShader, 'normal_pars_fragment') === null ? '' : '#define FAROL_VERTEX_NORMAL\n';
      const layers = header.includes(LAYERS);
      const defines = `${normal}${layers ? '#define FAROL_LAYERS_OF_OBJECT\n' : ''}`;
      if (layers) shader.vertexShader = withLayers(shader.vertexShader);
      let text = replaceChunk(fragmentShader, 'lights_pars_begin', (pars) => `${pars}\n${defines}${COUNT}${header}`);
      text = replaceChunk(text, 'lights_fragment_begin', begin);
      text = shadowsInTarget(text);
      if (options.rewrite) text = options.rewrite(text, source);
      if (options.atEnd) text = beforeLastBrace(text, options.atEnd);
      shader.fragmentShader = text;
    },
  };
}
