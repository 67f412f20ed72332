import { Material } from 'three';
import { beforeLastBrace } from './beforeLastBrace';
import { withLayers } from './layersAttribute';
import { lightsFragmentBegin } from './lightsFragmentBegin';
import type { TwinKind, TwinShader } from './TwinKind';

export interface LitTwinOptions {
  readonly key: string;
  /** Microshader that defines FAROL_FOR_EACH_LIGHT. */
  readonly loop: string;
  readonly chunks?: readonly string[];
  /** Shades light by light even where sums would do. Default false. */
  readonly oneByOne?: boolean;
  readonly properties?: TwinKind['properties'];
  /** Leaves three's own light loops out. Default true: they stay. */
  readonly withThreeLights?: boolean;
  readonly variant?: (source: Material) => string;
  /** Statements put at the very end of main(), where gl_FragColor is complete. */
  readonly atEnd?: string;
  /** Last rewrite of the fragment shader. */
  readonly rewrite?: (fragmentShader: string, source: Material) => string;
}

const LIGHTS = '#include <lights_fragment_begin>';
const PARS = '#include <lights_pars_begin>';
/** In lightMaskLayers.glsl. */
const LAYERS = '#define FAROL_LAYERS';
const NORMAL = '#include <normal_pars_fragment>';

/** Loops that differ from pixel to pixel. In them three's toon shading, which takes derivatives, means nothing. */
const LISTS: ReadonlySet<string> = new Set(['lightLoopTiled', 'lightListClustered']);

/** A kind of twin of lit materials: three's shader with Farol's light loop in it. */
export function litTwin(options: LitTwinOptions): TwinKind {
  const chunksOf = (loop: string, oneByOne: boolean) => [
    ...(oneByOne ? ['lightOneByOne'] : []),
    ...['ambientLight', loop, 'shadeThree', ...(options.chunks ?? [])],
  ];
  const chunks = chunksOf(options.loop, options.oneByOne ?? false);
  const ownChunks = chunksOf(options.loop, true);
  const toonChunks = LISTS.has(options.loop) ? ['shadeToon', ...chunks] : chunks;
  const ownToonChunks = chunksOf(LISTS.has(options.loop) ? 'lightLoopAll' : options.loop, false);
  const begin = () => lightsFragmentBegin(options.withThreeLights ?? true);
  return {
    key: options.key,
    chunks(source) {
      // the host's own changes of three's lighting functions count
      const own = source.onBeforeCompile !== Material.prototype.onBeforeCompile;
      const { isMeshToonMaterial } = source as Material & { isMeshToonMaterial?: boolean };
      if (isMeshToonMaterial) return own ? ownToonChunks : toonChunks;
      return own ? ownChunks : chunks;
    },
    ...(options.properties && { properties: options.properties }),
    ...(options.variant && { variant: options.variant }),
    patch(shader: TwinShader, source: Material, header: string) {
      const normal = shader.fragmentShader.includes(NORMAL) ? '#define FAROL_VERTEX_NORMAL\n' : '';
      const layers = header.includes(LAYERS);
      const defines = `${normal}${layers ? '#define FAROL_LAYERS_OF_OBJECT\n' : ''}`;
      if (layers) shader.vertexShader = withLayers(shader.vertexShader);
      let text = shader.fragmentShader.replace(PARS, () => `${PARS}\n${defines}${header}`).replace(LIGHTS, begin);
      if (options.rewrite) text = options.rewrite(text, source);
      if (options.atEnd) text = beforeLastBrace(text, options.atEnd);
      shader.fragmentShader = text;
    },
  };
}
