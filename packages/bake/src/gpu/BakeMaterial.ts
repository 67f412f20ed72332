import emitters from '../trace/emitters.glsl?raw';
import sampleCount from '../lightmap/sampleCount.glsl?raw';
import lightTable from '../trace/lightTable.glsl?raw';
import random from '../trace/random.glsl?raw';
import sky from '../trace/sky.glsl?raw';
import tables from '../trace/tables.glsl?raw';
import traverse from '../trace/traverse.glsl?raw';
import { GLSL3, type IUniform, NoBlending, RawShaderMaterial, type ShaderMaterialParameters } from 'three';
import { composeShader } from './composeShader';

/** GLSL texts for `#include`, by name. */
const chunks = { emitters, lightTable, random, sampleCount, sky, tables, traverse };

const PRECISION = 'precision highp float;\nprecision highp int;\nprecision highp sampler2DArray;\n';

/** Shader of one pass of a bake: without depth test, blending (by default) or three's material features. */
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
