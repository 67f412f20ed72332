import { NoBlending, type IUniform } from 'three';
import { beforeLastBrace } from '../../three/beforeLastBrace';
import { hasDepthTwin } from '../../materials/depthTwin';
import { afterChunkOrAtEnd } from '../../three/replaceChunk';
import type { TwinKind, TwinShader } from '../../materials/TwinKind';
import type { RenderItem } from '../../frame/RenderItem';
import motionVertexHeader from './motionVertexHeader.glsl?raw';
import motionVertex from './motionVertex.glsl?raw';

/** Matches the start of a shader's main(), however it is spaced. */
const MAIN = /\bvoid\s+main\s*\(/;
const VARYINGS = 'varying highp vec4 farol_now;\nvarying highp vec4 farol_before;\n';
const WRITE =
  'gl_FragColor = vec4(0.5 * (farol_now.xy / farol_now.w - farol_before.xy / farol_before.w), farol_before.w - farol_now.w, 1.0);\nif (true) return;';

/**
 * Two kinds of twins (materials in place of the host's) that write a surface's motion since the last frame. They share
 * a program, and draws alternate between them: three uploads uniforms only if the next draw has another material.
 * @param uniforms - uniforms of motionVertexHeader.glsl
 */
export function motionTwins(uniforms: Record<string, IUniform>): readonly [TwinKind, TwinKind] {
  const kind = (): TwinKind => ({
    key: 'motion',
    chunks: () => [],
    // the picture already has the same depth here: the offset lets the motion pass the depth test despite rounding
    properties: {
      blending: NoBlending,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: 0,
      polygonOffsetUnits: -4,
    },
    patch(shader: TwinShader) {
      Object.assign(shader.uniforms, uniforms);
      const vertex = shader.vertexShader.replace(MAIN, (main) => `${motionVertexHeader}\n${main}`);
      shader.vertexShader = `${VARYINGS}${beforeLastBrace(vertex, motionVertex)}`;
      shader.fragmentShader = VARYINGS + afterChunkOrAtEnd(shader.fragmentShader, 'alphahash_fragment', WRITE);
    },
  });
  return [kind(), kind()];
}

/** True for draws whose motion the twins can draw; other draws count as still. */
export function hasMotionTwin(item: RenderItem): boolean {
  const material = item.material as RenderItem['material'] & {
    isMeshBasicMaterial?: boolean;
    isMeshMatcapMaterial?: boolean;
  };
  const supported =
    item.shading === 'lit' || material.isMeshBasicMaterial === true || material.isMeshMatcapMaterial === true;
  return supported && material.depthWrite && hasDepthTwin(material);
}
