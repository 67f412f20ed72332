import { NoBlending, type IUniform } from 'three';
import { beforeLastBrace } from '../../three/beforeLastBrace';
import { afterChunkOrAtEnd } from '../../three/replaceChunk';
import type { TwinKind, TwinShader } from '../../materials/TwinKind';
import edgeFragment from './edgeFragment.glsl?raw';

const KEPT = 'float farol_shown;\nbool farol_keeps = false;\nvec4 farol_kept;\n';
const LAST = 'if (farol_keeps) gl_FragColor = farol_kept; else gl_FragColor.a += farol_shown;';
// gl_Position.zw, from which depth is computed: gl_FragCoord.z of a multisampled fragment may be that of a sample
const VARYING = 'varying highp vec2 farol_edgeZW;\n';

/**
 * Kind of twin (material in place of the host's) for an opaque draw that takes the surface's colour from the finished
 * picture, and shades only where the picture does not show the surface.
 * @param uniforms - uniforms of edgeColor.glsl, and `farol_reuse`: whether neighbouring pixels' colours may be used,
 *   `farol_shades`: whether surfaces that the picture does not show are shaded
 */
export function edgeTwin(kind: TwinKind, uniforms: Record<string, IUniform>): TwinKind {
  return {
    ...kind,
    key: `${kind.key}-edges`,
    chunks: (source) => [...kind.chunks(source), 'edgeColor'],
    properties: { ...kind.properties, blending: NoBlending },
    patch(shader: TwinShader, source, header) {
      kind.patch(shader, source, header);
      Object.assign(shader.uniforms, uniforms);
      shader.vertexShader = VARYING + beforeLastBrace(shader.vertexShader, 'farol_edgeZW = gl_Position.zw;');
      const text = afterChunkOrAtEnd(shader.fragmentShader, 'alphahash_fragment', edgeFragment);
      const own = text.includes('bool farol_edgeColor') ? '' : `${header}\n`;
      shader.fragmentShader = `${VARYING}uniform bool farol_reuse, farol_shades;\n${KEPT}${own}${beforeLastBrace(text, LAST)}`;
    },
  };
}
