import { GLSL3, type IUniform, NoBlending, RawShaderMaterial, type ShaderMaterialParameters } from 'three';
import { chunks } from './chunks';
import { composeShader } from './composeShader';

const PRECISION = 'precision highp float;\nprecision highp int;\nprecision highp sampler2DArray;\n';

/** Shader of a pass of a bake: no depth, no blending unless asked for, nothing of three's materials. */
export class BakeMaterial extends RawShaderMaterial {
  constructor(
    name: string,
    vertex: string,
    fragment: string,
    uniforms: Record<string, IUniform>,
    more: ShaderMaterialParameters = {},
  ) {
    super({
      ...{ name: `farol bake ${name}`, glslVersion: GLSL3, depthTest: false, depthWrite: false, blending: NoBlending },
      vertexShader: PRECISION + vertex,
      fragmentShader: PRECISION + composeShader(fragment, chunks),
      uniforms,
      ...more,
    });
  }
}
