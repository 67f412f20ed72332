import {
  AdditiveBlending,
  CustomBlending,
  GLSL3,
  type Material,
  MultiplyBlending,
  NoBlending,
  NormalBlending,
  OneFactor,
  ShaderChunk,
  type ShaderMaterial,
  SubtractiveBlending,
} from 'three';
import { OutputMaterial } from '../../gpu/PassMaterial';
import { plainBack, plainFront, plainWhole } from '../../materials/plainTwins';
import type { TwinKind } from '../../materials/TwinKind';
import { beforeLastBrace } from '../../three/beforeLastBrace';
import { findChunk } from '../../three/replaceChunk';
import mediaOn from './mediaOn.glsl?raw';

/** Blending of a draw, which decides how fog is applied to its colour. */
type Blend = 'over' | 'premultiplied' | 'added' | 'multiplied';

const COLOUR: Record<Blend, string> = {
  over: 'gl_FragColor.rgb * media.a + media.rgb',
  premultiplied: 'gl_FragColor.rgb * media.a + media.rgb * gl_FragColor.a',
  added: 'gl_FragColor.rgb * media.a',
  multiplied: 'mix(vec3(1.0), gl_FragColor.rgb, media.a)',
};

/** GLSL that applies fog, except at the far end of depth (such as a sky), which is fogged with the background. */
const statement = (blend: Blend): string => `if (gl_FragCoord.z > 0.0 && gl_FragCoord.z < 1.0) {
  vec4 media = farol_mediaAt(1.0 / gl_FragCoord.w);
  gl_FragColor.rgb = ${COLOUR[blend]};
}`;

const SEEN = 'textureBicubic( transmissionSamplerMap, fragCoord.xy, lod )';
const GLASS = ShaderChunk.transmission_pars_fragment.replace(SEEN, () => `farol_behindMedia( ${SEEN} )`);
const MAIN = /\bvoid\s+main\s*\(/;
const PLAIN: readonly TwinKind[] = [plainWhole, plainBack, plainFront];

function blendOf({ blending, blendSrc, blendDst, transparent }: Material): Blend {
  if (blending === NoBlending || (blending === NormalBlending && !transparent)) return 'over';
  if (blending === AdditiveBlending || blending === SubtractiveBlending) return 'added';
  if (blending === MultiplyBlending) return 'multiplied';
  if (blending !== CustomBlending) return 'over';
  if (blendDst === OneFactor) return 'added';
  return blendSrc === OneFactor ? 'premultiplied' : 'over';
}

/** Whether a draw of a material by a kind of twin writes a colour to be fogged. */
export function isFogged(kind: TwinKind, material: Material): boolean {
  const { role } = kind;
  if (role === 'gbuffer' || kind.isSum === true) return false;
  if (role === undefined && !PLAIN.includes(kind) && kind.key !== 'shadow-mask') return false;
  const { isShaderMaterial, isRawShaderMaterial, glslVersion, fog } = material as ShaderMaterial & {
    isRawShaderMaterial?: boolean;
  };
  if (isShaderMaterial !== true) return (fog as boolean | undefined) !== false;
  // the shaders of particles and of other draws of Farol's own apply fog themselves
  return isRawShaderMaterial !== true && glslVersion !== GLSL3 && !(material instanceof OutputMaterial);
}

/** Kind of twin (material in place of the host's) that applies the fog between eye and surface before tone mapping. */
export function foggedTwin(kind: TwinKind): TwinKind {
  const variant = (source: Material) => `${kind.variant?.(source) ?? ''}${blendOf(source)}`;
  return {
    ...kind,
    key: `${kind.key}-fogged`,
    variant,
    patch(shader, source, header) {
      kind.patch(shader, source, header);
      const before = findChunk(shader.fragmentShader, 'tonemapping_fragment');
      const fog = statement(blendOf(source));
      let text = shader.fragmentShader;
      text = before === null ? beforeLastBrace(text, fog) : text.replace(before, () => `${fog}\n${before}`);
      const lookUp = findChunk(text, 'transmission_pars_fragment');
      // the picture behind glass is fogged up to the eye already: keeps only the fog behind the glass
      if (lookUp !== null) text = text.replace(lookUp, () => `${mediaOn}\n${GLASS}`);
      else text = text.replace(MAIN, (main) => `${mediaOn}\n${main}`);
      shader.fragmentShader = text;
    },
  };
}
