import type { Material } from 'three';
import { beforeLastBrace } from './beforeLastBrace';
import { lightsFragmentBegin } from './lightsFragmentBegin';
import type { TwinKind, TwinShader } from './TwinKind';

export interface LitTwinOptions {
  readonly key: string;
  /** Microshader that defines FAROL_FOR_EACH_LIGHT. */
  readonly loop: string;
  readonly chunks?: readonly string[];
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

/** A kind of twin of lit materials: three's shader with Farol's light loop in it. */
export function litTwin(options: LitTwinOptions): TwinKind {
  const chunks = ['ambientLight', options.loop, 'shadeThree', ...(options.chunks ?? [])];
  const toonChunks = ['ambientLight', loopOfToon(options.loop), 'shadeThree', ...(options.chunks ?? [])];
  const begin = () => lightsFragmentBegin(options.withThreeLights ?? true);
  return {
    key: options.key,
    chunks: (source) =>
      (source as Material & { isMeshToonMaterial?: boolean }).isMeshToonMaterial ? toonChunks : chunks,
    ...(options.properties && { properties: options.properties }),
    ...(options.variant && { variant: options.variant }),
    patch(shader: TwinShader, source: Material, header: string) {
      let text = shader.fragmentShader.replace(PARS, () => `${PARS}\n${header}`).replace(LIGHTS, begin);
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
