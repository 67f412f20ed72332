import { beforeLastBrace } from '../../three/beforeLastBrace';
import type { TwinKind } from '../../materials/TwinKind';

/** WebGL 2 has at least 16 vertex attributes; three's own materials need fewer. */
const LOCATION = 15;

const DECLARATION = `layout(location = ${LOCATION}) in highp vec2 farol_objectAttribute;\nvarying highp vec2 farol_object;\n`;

/** Vertex shader code: each instance has an object number of its own. */
const NUMBER = `farol_object = farol_objectAttribute;
#if defined( USE_BATCHING )
  farol_object.x = mod(farol_object.x + 89.0 * float(getIndirectIndex(gl_DrawID)), 2047.0) + 1.0;
#elif defined( USE_INSTANCING )
  farol_object.x = mod(farol_object.x + 89.0 * float(gl_InstanceID), 2047.0) + 1.0;
#endif
`;

/**
 * Twin kind whose shader also gets the object's number, instances one each, as the varying `farol_object`. `setObject`
 * sets it for each draw as a vertex attribute without an array, which changes without a change of material.
 */
export function withObject(kind: TwinKind): TwinKind {
  return {
    ...kind,
    patch(shader, source, header) {
      kind.patch(shader, source, header);
      shader.vertexShader = `${DECLARATION}${beforeLastBrace(shader.vertexShader, NUMBER)}`;
    },
  };
}

/**
 * Sets `farol_object` for the draws that follow.
 * @param number - as `objectNumber` gives it
 * @param corner - as `stippleCorner` gives it, 0 for opaque things
 */
export function setObject(gl: WebGL2RenderingContext, number: number, corner: number): void {
  gl.vertexAttrib2f(LOCATION, number, corner);
}

/** Resets the attribute to its value in a new context. */
export function resetObject(gl: WebGL2RenderingContext): void {
  gl.vertexAttrib4f(LOCATION, 0, 0, 0, 1);
}
