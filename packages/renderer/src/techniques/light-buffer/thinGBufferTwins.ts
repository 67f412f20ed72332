import { BackSide, FrontSide, NoBlending, ShaderChunk, type IUniform, type Vector4 } from 'three';
import { beforeLastBrace } from '../../three/beforeLastBrace';
import type { ForwardTwins } from '../../materials/forwardTwin';
import { litTwin } from '../../materials/litTwin';
import { withObject } from './objectAttribute';
import { findChunk, replaceChunk, replacePart } from '../../three/replaceChunk';
import type { TwinKind } from '../../materials/TwinKind';

/** Twins that write the thin G-buffer, for opaque materials and for layers of transparent ones. */
export interface ThinGBufferTwins {
  readonly opaque: TwinKind;
  readonly stippled: ForwardTwins;
}

const SPECULAR_ANTIALIASING = 'vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );';

/** Scales normal derivatives to a pixel: three widens highlights by them, and a texel may be wider than a pixel. */
function byPixels(text: string): string {
  if (findChunk(text, 'lights_physical_fragment') === null) return `uniform float farol_thinScale;\n${text}`;
  const chunk = replacePart(
    ShaderChunk.lights_physical_fragment,
    SPECULAR_ANTIALIASING,
    SPECULAR_ANTIALIASING.replace('max(', 'farol_thinScale * max('),
  );
  return `uniform float farol_thinScale;\n${replaceChunk(text, 'lights_physical_fragment', () => chunk)}`;
}

const FIT = 'gl_Position.xy = gl_Position.xy * farol_fit.xy + gl_Position.w * farol_fit.zw;';

/**
 * @param scale - side of the buffer divided by that of the picture
 * @param fit - transform of `gridFit`, from the picture's normalised device coordinates to the buffer's
 */
export function thinGBufferTwins(scale: IUniform<number>, fit: IUniform<Vector4>): ThinGBufferTwins {
  const kind = (part: string, atEnd: string, properties: TwinKind['properties']): TwinKind => {
    const lit = litTwin({
      key: `thin-gbuffer${part}`,
      loop: 'lightLoopNone',
      withThreeLights: false,
      chunks: ['thinGBufferWrite'],
      properties: { fog: false, ...properties },
      rewrite: byPixels,
      atEnd,
    });
    return withObject({
      ...lit,
      patch(shader, source, header) {
        lit.patch(shader, source, header);
        shader.uniforms.farol_thinScale = scale;
        shader.uniforms.farol_fit = fit;
        shader.vertexShader = `uniform highp vec4 farol_fit;\n${beforeLastBrace(shader.vertexShader, FIT)}`;
      },
    });
  };
  const stippled = (part: string, properties: TwinKind['properties']) =>
    kind(`-stippled${part}`, 'FAROL_STIPPLE\nFAROL_WRITE_THIN', {
      blending: NoBlending,
      depthWrite: true,
      ...properties,
    });
  return {
    opaque: kind('', 'FAROL_WRITE_THIN', {}),
    stippled: {
      whole: stippled('', {}),
      back: stippled('-back', { side: BackSide }),
      front: stippled('-front', { side: FrontSide }),
    },
  };
}
