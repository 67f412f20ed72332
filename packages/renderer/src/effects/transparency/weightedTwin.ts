import {
  AddEquation,
  CustomBlending,
  GLSL3,
  NormalBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  type ShaderMaterial,
  ZeroFactor,
} from 'three';
import { beforeLastBrace } from '../../three/beforeLastBrace';
import type { TwinKind } from '../../materials/TwinKind';
import type { RenderItem } from '../../frame/RenderItem';
import weightedColor from './weightedColor.glsl?raw';

/** One blend function for both attachments: sums in rgb, the product of transmittances in alpha. */
const BLENDING = {
  blending: CustomBlending,
  blendEquation: AddEquation,
  blendSrc: OneFactor,
  blendDst: OneFactor,
  blendEquationAlpha: AddEquation,
  blendSrcAlpha: ZeroFactor,
  blendDstAlpha: OneMinusSrcAlphaFactor,
  depthWrite: false,
} as const;

/** Kind of twin (material in place of the host's) that adds a transparent draw's colour to the weighted sums. */
export function weightedTwin(kind: TwinKind): TwinKind {
  return {
    ...kind,
    key: `${kind.key}-weighted`,
    properties: { ...kind.properties, ...BLENDING },
    patch(shader, source, header) {
      kind.patch(shader, source, header);
      shader.fragmentShader = `layout(location = 1) out highp vec4 farol_outWeight;\n${beforeLastBrace(shader.fragmentShader, weightedColor)}`;
    },
  };
}

/** True for materials blended by their opacity; other blendings are independent of order, or rely on it. */
export function isWeighted({ material, shading }: RenderItem): boolean {
  const shader = material as ShaderMaterial & { isRawShaderMaterial?: boolean };
  const ownOutputs = shader.isRawShaderMaterial === true || shader.glslVersion === GLSL3;
  if (shading === 'nodes' || ownOutputs) return false;
  return material.blending === NormalBlending && material.depthTest && material.colorWrite;
}
