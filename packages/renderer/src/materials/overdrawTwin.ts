import { AddEquation, CustomBlending, GLSL3, OneFactor, type Material, type ShaderMaterial } from 'three';
import type { TwinKind, TwinShader } from './TwinKind';

/** Twin that adds one to each pixel that the material would have shaded. */
export const overdrawTwin: TwinKind = {
  key: 'overdraw',
  chunks: () => [],
  properties: {
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: OneFactor,
    blendDst: OneFactor,
    blendEquationAlpha: null,
    blendSrcAlpha: null,
    blendDstAlpha: null,
  },
  patch(shader: TwinShader) {
    const at = shader.fragmentShader.lastIndexOf('}');
    shader.fragmentShader = `${shader.fragmentShader.slice(0, at)}\ngl_FragColor = vec4(1.0, 0.0, 0.0, 1.0);\n}`;
  },
};

/** False for shader materials that write their own outputs. */
export function canCountOverdraw(material: Material): boolean {
  const shader = material as ShaderMaterial & { isRawShaderMaterial?: boolean };
  return shader.isRawShaderMaterial !== true && shader.glslVersion !== GLSL3;
}
