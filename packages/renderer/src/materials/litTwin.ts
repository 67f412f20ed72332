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

/** A kind of twin of lit materials: three's shader with Farol's light loop in it. */
export function litTwin(options: LitTwinOptions): TwinKind {
  const chunksOf = (loop: string, oneByOne: boolean) => [
    ...(oneByOne ? ['lightOneByOne'] : []),
    ...['ambientLight', loop, 'shadeThree', ...(options.chunks ?? [])],
  ];
  const chunks = chunksOf(options.loop, options.oneByOne ?? false);
  const ownChunks = chunksOf(options.loop, true);
  const toonChunks = chunksOf(loopOfToon(options.loop), false);
  const begin = () => lightsFragmentBegin(options.withThreeLights ?? true);
  return {
    key: options.key,
    chunks(source) {
      if ((source as Material & { isMeshToonMaterial?: boolean }).isMeshToonMaterial) return toonChunks;
      // the host's own changes of three's lighting functions count
      return source.onBeforeCompile === Material.prototype.onBeforeCompile ? chunks : ownChunks;
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

/** Toon shading takes derivatives in the light loop, which mean nothing unless all pixels go through the same lights. */
function loopOfToon(loop: string): string {
  return loop === 'lightLoopNone' || loop === 'lightLoopOne' ? loop : 'lightLoopAll';
}
